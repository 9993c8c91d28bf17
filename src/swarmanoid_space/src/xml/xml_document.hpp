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

/// What is well-formed, in UTF-8 whatever the text declares, without a document type: so there are no entities but the
/// five of XML, and nothing is read but the text. Processing instructions are passed over before the root element, and
/// refused from there on. Time and memory are proportional to the length of the text. Thread-safe.
/// @return with a root element; CDATA is text, and white space between tags is left out
/// @throws ConfigError with the line of the first mistake, also for tags with more than 1000 attributes, elements
/// nested more than 200 deep, and a text, a name or a value as long as libxml2 takes for an attack (10 MB, 50 kB, 10
/// MB)
XmlDocument parseXml(const std::string& text, const std::string& file, XmlNamespaces namespaces);

/// Where an element begins, or the text of a text node but for white space; 0 for what was not in the file.
int lineOf(const xmlNode* node);

}  // namespace swarmanoid
