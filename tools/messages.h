/* What the program says on stderr: one line a message, with its name before it. */
#pragma once

/* Exit codes. */
enum { DONE = 0, COULD_NOT = 1, WRONG_USAGE = 2 };

/* Says one line, in UTF-8. Characters that cannot be seen stand there as <U+200D>, other bytes (a file name may hold any) as
 * <0xFF>. */
__attribute__((format(printf, 1, 2))) void say(const char *format, ...);

/* Says it and gives COULD_NOT. */
__attribute__((format(printf, 1, 2))) int fail(const char *format, ...);

/* Says it with a pointer to the help of `command` (NULL: of the program) and gives WRONG_USAGE. */
__attribute__((format(printf, 2, 3))) int misuse(const char *command, const char *format, ...);
