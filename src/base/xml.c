#include "base/xml.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/utf.h"

/* ---- documents -------------------------------------------------------------------------------------------- */

/* Notes what a call of the writer gave: below 0 it has failed. */
static void note(mt_xml *xml, int outcome) {
    if (outcome < 0) xml->failed = true;
}

mt_xml mt_xml_begin(void) {
    mt_xml xml = {.buffer = xmlBufferCreate()};
    if (xml.buffer) xml.writer = xmlNewTextWriterMemory(xml.buffer, 0);
    xml.failed = !xml.writer;
    if (xml.failed) return xml;
    note(&xml, xmlTextWriterStartDocument(xml.writer, NULL, "UTF-8", NULL));
    note(&xml, xmlTextWriterSetIndent(xml.writer, 1));
    note(&xml, xmlTextWriterSetIndentString(xml.writer, BAD_CAST "  "));
    return xml;
}

mt_status mt_xml_end(mt_xml *xml, const char **text, size_t *length) {
    if (!xml->failed) note(xml, xmlTextWriterEndDocument(xml->writer));
    if (xml->failed) return MT_NO_MEMORY;
    *text = (const char *)xmlBufferContent(xml->buffer);
    *length = (size_t)xmlBufferLength(xml->buffer);
    return MT_OK;
}

void mt_xml_free(mt_xml *xml) {
    if (xml->writer) xmlFreeTextWriter(xml->writer);
    if (xml->buffer) xmlBufferFree(xml->buffer);
    *xml = (mt_xml){0};
}

/* ---- elements --------------------------------------------------------------------------------------------- */

void mt_xml_open(mt_xml *xml, const char *element) {
    if (!xml->failed) note(xml, xmlTextWriterStartElement(xml->writer, BAD_CAST element));
}

void mt_xml_close(mt_xml *xml) {
    if (!xml->failed) note(xml, xmlTextWriterEndElement(xml->writer));
}

/* XML 1.0, production 2. */
static bool is_xml_char(uint32_t c) {
    return c == '\t' || c == '\n' || c == '\r' || (c >= ' ' && c != 0xFFFE && c != 0xFFFF);
}

/* The text without what XML cannot hold, up to where it is no UTF-8; from mt_new, NULL when out of memory. */
static char *clean(const char *text) {
    char *copy = mt_new(strlen(text) + 1, 1);
    size_t length = 0;
    uint32_t c;
    while (copy && mt_utf8_next(&text, &c) && c)
        if (is_xml_char(c)) length += (size_t)mt_utf8_put(c, copy + length);
    return copy;
}

void mt_xml_attribute(mt_xml *xml, const char *name, const char *value) {
    char *copy = clean(value);
    if (!copy) xml->failed = true;
    if (!xml->failed) note(xml, xmlTextWriterWriteAttribute(xml->writer, BAD_CAST name, BAD_CAST copy));
    mt_free(copy);
}

void mt_xml_number(mt_xml *xml, const char *name, int value) {
    char text[16];
    snprintf(text, sizeof text, "%d", value);
    if (!xml->failed) note(xml, xmlTextWriterWriteAttribute(xml->writer, BAD_CAST name, BAD_CAST text));
}

void mt_xml_text(mt_xml *xml, const char *element, const char *text) {
    char *copy = clean(text);
    if (!copy) xml->failed = true;
    if (!xml->failed) note(xml, xmlTextWriterWriteElement(xml->writer, BAD_CAST element, BAD_CAST copy));
    mt_free(copy);
}

/* ---- property lists --------------------------------------------------------------------------------------- */

void mt_plist_open(mt_xml *xml, const char *element) {
    if (!xml->failed)
        note(xml, xmlTextWriterWriteDTD(xml->writer, BAD_CAST "plist", BAD_CAST "-//Apple//DTD PLIST 1.0//EN",
                                        BAD_CAST "http://www.apple.com/DTDs/PropertyList-1.0.dtd", NULL));
    mt_xml_open(xml, "plist");
    mt_xml_attribute(xml, "version", "1.0");
    mt_xml_open(xml, element);
}

void mt_plist_close(mt_xml *xml) {
    mt_xml_close(xml);
    mt_xml_close(xml);
}

static void put_key(mt_xml *xml, const char *key) {
    if (key) mt_xml_text(xml, "key", key);
}

void mt_plist_group(mt_xml *xml, const char *key, const char *element) {
    put_key(xml, key);
    mt_xml_open(xml, element);
}

void mt_plist_string(mt_xml *xml, const char *key, const char *text) {
    if (!text) return;
    put_key(xml, key);
    mt_xml_text(xml, "string", text);
}

void mt_plist_integer(mt_xml *xml, const char *key, int64_t value) {
    char text[32];
    snprintf(text, sizeof text, "%lld", (long long)value);
    put_key(xml, key);
    mt_xml_text(xml, "integer", text);
}

/* Whole numbers as integers, which every reader takes. */
void mt_plist_real(mt_xml *xml, const char *key, double value) {
    char text[32];
    snprintf(text, sizeof text, "%g", isfinite(value) ? value : 0);
    put_key(xml, key);
    mt_xml_text(xml, strpbrk(text, ".e") ? "real" : "integer", text);
}

void mt_plist_bool(mt_xml *xml, const char *key, bool value) {
    put_key(xml, key);
    mt_xml_open(xml, value ? "true" : "false");
    mt_xml_close(xml);
}
