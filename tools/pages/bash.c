/* Completion for bash 4 and later, by itself or loaded by the package bash-completion. */
#include "pages.h"

#include "base/memory.h"

#include <stdio.h>

/* What stands before the tables. bash cuts words at = too, so that --method=jo is three of them. */
static const char head[] =
    "# bash completion for morphotype                            -*- shell-script -*-\n"
    "\n"
    "# _morphotype_files EXTENSIONS: directories, and files with one of these; without any, all files.\n"
    "_morphotype_files() {\n"
    "    local file end\n"
    "    compopt -o filenames 2>/dev/null\n"
    "    while IFS= read -r file; do\n"
    "        end=${file##*.}\n"
    "        if [[ -z $1 || -d ${file/#\\~\\//$HOME/} || \" $1 \" == *\" ${end,,} \"* ]]; then\n"
    "            COMPREPLY+=(\"$file\")\n"
    "        fi\n"
    "    done < <(compgen -f -- \"${cur//\\\\/}\")\n"
    "}\n"
    "\n"
    "_morphotype() {\n"
    "    local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]}\n"
    "    local options reads writes words\n"
    "    COMPREPLY=()\n"
    "    if [[ $cur == = ]]; then\n"
    "        cur=\n"
    "    elif [[ $prev == = ]]; then\n"
    "        prev=${COMP_WORDS[COMP_CWORD-2]}\n"
    "    fi\n";

static const char tail[] = "    if [[ $cur == -* ]]; then\n"
                           "        COMPREPLY=($(compgen -W \"$options\" -- \"$cur\"))\n"
                           "    else\n"
                           "        _morphotype_files \"$reads\"\n"
                           "    fi\n"
                           "}\n"
                           "\n"
                           "complete -F _morphotype morphotype\n";

static void write_options(const cli_command *command) {
    const char *between = "";
    printf("options='");
    for (const option_row *row = option_rows; row->name; row++) {
        if (!option_is_taken(row, command)) continue;
        printf("%s--%s", between, row->name);
        if (row->is_short) printf(" -%c", row->letter);
        between = " ";
    }
    printf("'");
}

static void write_commands(void) {
    printf("    words='help --help --version");
    for (int i = 0; commands[i]; i++) printf(" %s", commands[i]->name);
    printf("'\n"
           "    if [[ $COMP_CWORD -eq 1 || $COMP_CWORD -eq 2 && $command == help ]]; then\n"
           "        COMPREPLY=($(compgen -W \"$words\" -- \"$cur\"))\n"
           "        return\n"
           "    fi\n"
           "    case $command in\n");
    for (int i = 0; commands[i]; i++) {
        printf("        %s) ", commands[i]->name);
        write_options(commands[i]);
        printf(" reads='%s' writes='%s' ;;\n", commands[i]->reads, commands[i]->writes);
    }
    printf("        *) return ;;\n"
           "    esac\n");
}

/* What follows an option that takes an argument. */
static void write_argument(const option_row *row) {
    char *words = argument_words(row);
    if (!row->argument || !words) {
        mt_free(words);
        return;
    }
    printf("        ");
    if (row->is_short) printf("-%c | ", row->letter);
    printf("--%s) ", row->name);
    if (argument_is_file(row))
        printf("_morphotype_files \"%s\"; ", row->letter == 'o' ? "$writes" : "");
    else if (*words)
        printf("COMPREPLY=($(compgen -W '%s' -- \"$cur\")); ", words);
    printf("return ;;\n");
    mt_free(words);
}

void write_bash(void) {
    fputs(head, stdout);
    write_commands();
    printf("    case $prev in\n");
    for (const option_row *row = option_rows; row->name; row++) write_argument(row);
    printf("    esac\n%s", tail);
}
