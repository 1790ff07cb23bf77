/* pages man [COMMAND]|bash|zsh|fish: see pages.h. */
#include "pages.h"

#include "messages.h"

#include <stdio.h>
#include <string.h>

static int write_page(int argc, char **argv) {
    const cli_command *command = argc > 2 ? command_find(argv[2]) : NULL;
    if (argc > 2 && !command) return fail("%s is no command", argv[2]);
    write_manual(command);
    return DONE;
}

int main(int argc, char **argv) {
    const struct {
        const char *name;
        void (*write)(void);
    } shells[] = {{"bash", write_bash}, {"zsh", write_zsh}, {"fish", write_fish}};
    if (argc > 1 && strcmp(argv[1], "man") == 0) return write_page(argc, argv);
    for (size_t i = 0; argc == 2 && i < sizeof shells / sizeof *shells; i++)
        if (strcmp(argv[1], shells[i].name) == 0) return shells[i].write(), DONE;
    fprintf(stderr, "usage: pages man [COMMAND] | bash | zsh | fish\n");
    return WRONG_USAGE;
}
