/* A document of XML from untrusted bytes, as libxml2's tree. Nothing is fetched, and a document that declares entities is refused. */
#pragma once

#include <libxml/tree.h>

#include "base/memory.h"
#include "morphotype.h"

/* Levels of elements. */
#define MT_XML_DEPTH_MAX 100

typedef enum mt_xml_fault {
    MT_XML_DAMAGED, /* not well-formed */
    MT_XML_ENTITIES,
    MT_XML_DEEP, /* over MT_XML_DEPTH_MAX levels */
} mt_xml_fault;

/* Reads a document, for xmlFreeDoc. MT_BAD_DRAWING, *fault then says why; MT_NO_MEMORY. */
mt_status mt_xml_read(const uint8_t *bytes, size_t length, xmlDoc **document, mt_xml_fault *fault);
