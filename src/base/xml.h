/* XML and property lists in memory, by libxml2's writer.
 *
 * A document that could not grow has failed and takes nothing more; mt_xml_end tells. Text is UTF-8; characters that XML
 * 1.0 cannot hold are left out. */
#pragma once

#include <libxml/xmlwriter.h>

#include "morphotype.h"

typedef struct mt_xml {
    xmlBufferPtr buffer;
    xmlTextWriterPtr writer;
    bool failed;
} mt_xml;

mt_xml mt_xml_begin(void);
/* The document's text, which belongs to it; MT_NO_MEMORY when it has failed. */
mt_status mt_xml_end(mt_xml *xml, const char **text, size_t *length);
void mt_xml_free(mt_xml *xml);

void mt_xml_open(mt_xml *xml, const char *element);
void mt_xml_close(mt_xml *xml); /* the element opened last */
void mt_xml_attribute(mt_xml *xml, const char *name, const char *value);
void mt_xml_number(mt_xml *xml, const char *name, int value); /* an attribute */
void mt_xml_text(mt_xml *xml, const char *element, const char *text);

/* Property lists. `key` is NULL for what stands in an array. */
void mt_plist_open(mt_xml *xml, const char *element); /* the document, and the outermost dict or array */
void mt_plist_close(mt_xml *xml);
void mt_plist_group(mt_xml *xml, const char *key,
                    const char *element); /* a dict or array; ends with mt_xml_close */
void mt_plist_string(mt_xml *xml, const char *key, const char *text); /* nothing for NULL */
void mt_plist_integer(mt_xml *xml, const char *key, int64_t value);
void mt_plist_real(mt_xml *xml, const char *key, double value);
void mt_plist_bool(mt_xml *xml, const char *key, bool value);
