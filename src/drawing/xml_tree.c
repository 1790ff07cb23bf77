#include "drawing/xml_tree.h"

#include <libxml/SAX2.h>
#include <libxml/parserInternals.h>
#include <limits.h>

static void stop(xmlParserCtxt *parser, mt_xml_fault why) {
    *(mt_xml_fault *)parser->_private = why;
    xmlStopParser(parser);
}

static void start_element(void *context, const xmlChar *name, const xmlChar *prefix, const xmlChar *uri,
                          int namespace_count, const xmlChar **namespaces, int attribute_count,
                          int defaulted_count, const xmlChar **attributes) {
    xmlParserCtxt *parser = context;
    if (parser->nodeNr >= MT_XML_DEPTH_MAX)
        stop(parser, MT_XML_DEEP);
    else
        xmlSAX2StartElementNs(context, name, prefix, uri, namespace_count, namespaces, attribute_count,
                              defaulted_count, attributes);
}

static void declare_entity(void *context, const xmlChar *name, int type, const xmlChar *public_id,
                           const xmlChar *system_id, xmlChar *content) {
    (void)name, (void)type, (void)public_id, (void)system_id, (void)content;
    stop(context, MT_XML_ENTITIES);
}

mt_status mt_xml_read(const uint8_t *bytes, size_t length, xmlDoc **document, mt_xml_fault *fault) {
    *fault = MT_XML_DAMAGED;
    if (length == 0 || length > INT_MAX) return MT_BAD_DRAWING;
    xmlParserCtxt *parser = xmlCreateMemoryParserCtxt((const char *)bytes, (int)length);
    if (!parser) return MT_NO_MEMORY;
    parser->_private = fault;
    xmlCtxtUseOptions(parser, XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING | XML_PARSE_NOCDATA);
    parser->sax->startElementNs = start_element;
    parser->sax->entityDecl = declare_entity;
    xmlParseDocument(parser);
    bool good = parser->wellFormed && parser->myDoc && !parser->disableSAX;
    bool memory = parser->errNo == XML_ERR_NO_MEMORY;
    if (good)
        *document = parser->myDoc;
    else
        xmlFreeDoc(parser->myDoc);
    parser->myDoc = NULL;
    xmlFreeParserCtxt(parser);
    return good ? MT_OK : memory ? MT_NO_MEMORY : MT_BAD_DRAWING;
}
