/// Reads XML strictly, into the tree of libxml2.
#pragma once

#include <libxml/tree.h>

#include <memory>
#include <string>

namespace swarmanoid {

struct XmlDocumentDeleter {
  void operator()(xmlDoc* document) const { xmlFreeDoc(document); }
};
using XmlDocument = std::unique_ptr<xmlDoc, XmlDocumentDeleter>;

enum class XmlNamespaces {
  kRefused,  ///< a name with a colon is refused, too
  kAllowed
};

/// Parses a well-formed document in UTF-8, whatever encoding the text declares, without a document type. So the only
/// entities are the five of XML, and nothing but the text is read. Processing instructions are skipped before the root
/// element, and refused after its start. Time and memory are proportional to the length of the text. Thread-safe.
/// @return with a root element; CDATA is text, and white space between tags is left out
/// @throws ConfigError with the line of the first mistake; also for tags with more than 1000 attributes, elements
/// nested more than 200 deep, and a text, a name or a value beyond libxml2's limits against attacks (10 MB, 50 kB, 10
/// MB)
XmlDocument parseXml(const std::string& text, const std::string& file, XmlNamespaces namespaces);

/// Line where an element, or the text of a text node without leading white space, begins; 0 for nodes that are not from
/// the file.
int lineOf(const xmlNode* node);

}  // namespace swarmanoid
