/* Text of any origin in a page of HTML. */
#pragma once

#include "base/buffer.h"

/* A control character: the page has nothing to show for it. */
bool mt_html_is_control(uint32_t code_point);
/* One character, escaped where it means something in markup or in a quoted attribute; U+FFFD for a control character.
 * MT_NO_MEMORY. */
mt_status mt_html_character(mt_buffer *text, uint32_t code_point);
/* UTF-8, character by character; bytes that are none become U+FFFD. MT_NO_MEMORY. */
mt_status mt_html_text(mt_buffer *text, const char *utf8);
