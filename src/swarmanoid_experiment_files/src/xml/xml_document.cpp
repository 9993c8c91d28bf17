#include "swarmanoid_experiment_files/xml/xml_document.hpp"

#include <libxml/SAX2.h>
#include <libxml/parser.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>

#include "swarmanoid_experiment_files/xml/xml_node.hpp"
#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid {
namespace {

constexpr int kMostAttributes = 1000;
constexpr int kMostNested = 200;

struct ContextDeleter {
  void operator()(xmlParserCtxt* context) const { xmlFreeParserCtxt(context); }
};

/// The first mistake; attached to the parser.
struct Findings {
  struct Mistake {
    std::string message;
    int line = 0;
  };

  XmlNamespaces namespaces = XmlNamespaces::kRefused;
  std::optional<Mistake> first;
};

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

xmlParserCtxt* parserOf(void* context) { return static_cast<xmlParserCtxt*>(context); }
Findings& findingsOf(void* context) { return *static_cast<Findings*>(parserOf(context)->_private); }

void refuse(void* context, const std::string& message, int line) {
  Findings& findings = findingsOf(context);
  if (!findings.first) {
    findings.first = Findings::Mistake{message, line};
  }
  xmlStopParser(parserOf(context));
}

/// Returns advice for messages about a special character that is not escaped.
std::string allowedInstead(int code) {
  const bool is_about_signs = code == XML_ERR_NAME_REQUIRED || code == XML_ERR_ENTITYREF_SEMICOL_MISSING ||
                              code == XML_ERR_UNDECLARED_ENTITY || code == XML_ERR_LT_IN_ATTRIBUTE;
  return is_about_signs ? ", allowed: &amp; and &lt; for the signs & and <" : "";
}

/// A template, because newer versions of the library pass a pointer to a constant error.
template <class Error>
void onError(void* context, Error error) {
  if (error->level != XML_ERR_FATAL || findingsOf(context).first) {
    return;  // later mistakes are consequences of the first one
  }
  std::string message = std::string("found no well-formed XML: ") + error->message;
  message.erase(message.find_last_not_of('\n') + 1);
  std::replace(message.begin(), message.end(), '\n', ' ');
  message += allowedInstead(error->code);
  if (error->code == XML_ERR_INVALID_CHAR && xmlCheckUTF8(parserOf(context)->input->cur) == 0) {
    message = "found bytes that are no text in UTF-8, allowed: UTF-8";
  }
  findingsOf(context).first = Findings::Mistake{message, error->line};
}

/// Stores a node's line: the library's own count stops at 65535, and refers to the end of a tag.
void keepLine(xmlNode* node, int line) { node->psvi = reinterpret_cast<void*>(static_cast<std::intptr_t>(line)); }

/// Returns the line of a tag. The parser is at its end, and a '<' in it can only be the first character.
int lineOfTag(const xmlParserInput& input) {
  int line = input.line;
  for (const xmlChar* at = input.cur; at > input.base && *at != '<'; --at) {
    line -= *at == '\n' ? 1 : 0;
  }
  return line;
}

void onElement(void* context, const xmlChar* name, const xmlChar* prefix, const xmlChar* uri, int namespace_count,
               const xmlChar** namespaces, int attribute_count, int defaulted_count, const xmlChar** attributes) {
  const int line = lineOfTag(*parserOf(context)->input);
  if (parserOf(context)->nodeNr >= kMostNested) {
    return refuse(context, "found elements nested more than " + std::to_string(kMostNested) + " deep, allowed: fewer",
                  line);
  }
  bool has_namespace = prefix != nullptr || namespace_count > 0;
  constexpr int kPointers = 5;  // per attribute: name, prefix, URI, begin and end of the value
  for (int i = 0; i < attribute_count; ++i) {
    has_namespace = has_namespace || attributes[kPointers * i + 1] != nullptr;
  }
  if (has_namespace && findingsOf(context).namespaces == XmlNamespaces::kRefused) {
    return refuse(context,
                  "found a name with a colon, or a namespace, in the tag of <" + std::string(characters(name)) +
                      ">, allowed: neither",
                  line);
  }
  xmlSAX2StartElementNs(context, name, prefix, uri, namespace_count, namespaces, attribute_count, defaulted_count,
                        attributes);
  if (xmlNode* node = parserOf(context)->node) {
    keepLine(node, line);
  }
}

void onText(void* context, const xmlChar* text, int length) {
  const xmlParserInput& input = *parserOf(context)->input;
  const xmlNode* parent = parserOf(context)->node;
  const auto last_is_text = [&] { return parent->last != nullptr && parent->last->type == XML_TEXT_NODE; };
  const char* end = characters(text) + length;
  const char* word = std::find_if_not(characters(text), end, isSpace);
  if (parent == nullptr || (word == end && *input.cur == '<' && !last_is_text())) {
    return;  // skips white space between tags, which would be half of the tree
  }
  xmlSAX2Characters(context, text, length);
  // all pieces of a text are in one node
  if (word != end && last_is_text() && lineOf(parent->last) == 0) {
    keepLine(parent->last, input.line - static_cast<int>(std::count(word, end, '\n')));
  }
}

void onDocumentType(void* context, const xmlChar* /*name*/, const xmlChar* /*external*/, const xmlChar* /*system*/) {
  refuse(context, "found '<!DOCTYPE', allowed: elements and comments <!-- ... -->", parserOf(context)->input->line);
}

void onProcessingInstruction(void* context, const xmlChar* target, const xmlChar* /*data*/) {
  if (xmlDocGetRootElement(parserOf(context)->myDoc) != nullptr) {
    refuse(context, "found '<?" + std::string(characters(target)) + "', allowed: elements and comments <!-- ... -->",
           parserOf(context)->input->line);
  }
}

[[noreturn]] void refuseAt(std::size_t place, const std::string& message, const std::string& text,
                           const std::string& file) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(place);
  throw ConfigError({file, 1 + static_cast<int>(std::count(text.begin(), end, '\n'))}, message);
}

/// Returns the end of a comment, CDATA section or instruction that begins at `begin`; `begin` if there is none. The
/// library does not stop at the first double hyphen in a comment, and then takes time quadratic in its length.
std::size_t endOfSection(const std::string& text, std::size_t begin, const std::string& file) {
  const auto after = [&](const std::string& opening, const std::string& closing) {
    if (text.compare(begin, opening.size(), opening) != 0) {
      return begin;
    }
    const std::size_t end = text.find(closing, begin + opening.size());
    return end == std::string::npos ? text.size() : end + closing.size();  // the library reports the missing end
  };
  const std::size_t hyphens = after("<!--", "--");
  if (hyphens != begin && hyphens < text.size() && text[hyphens] != '>') {
    refuseAt(hyphens, "found '--' in a comment, allowed: single hyphens, and '-->' as its end", text, file);
  }
  return std::max({hyphens, after("<![CDATA[", "]]>"), after("<?", "?>")});
}

/// Checks for contents that the library does not handle: it stops at a zero byte as at the end of the file, and takes
/// time quadratic in the number of a tag's attributes.
void checkForTheLibrary(const std::string& text, const std::string& file) {
  if (text.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw ConfigError({file}, "found a text of " + std::to_string(text.size()) + " characters, allowed: fewer");
  }
  if (const std::size_t zero = text.find('\0'); zero != std::string::npos) {
    refuseAt(zero, "found a zero byte, allowed: text", text, file);
  }
  int attributes = 0;
  char before = '\0';  // last character that is not white space
  std::size_t i = 0;
  while (i < text.size()) {
    if (text[i] == '<') {
      attributes = 0;
      if (const std::size_t end = endOfSection(text, i, file); end != i) {
        i = end;
        continue;
      }
    }
    const bool begins_value = before == '=' && (text[i] == '"' || text[i] == '\'');
    attributes += begins_value ? 1 : 0;
    if (attributes > kMostAttributes) {
      refuseAt(i, "found a tag with more than " + std::to_string(kMostAttributes) + " attributes, allowed: fewer", text,
               file);
    }
    before = isSpace(text[i]) ? before : text[i];
    ++i;
  }
}

}  // namespace

XmlDocument parseXml(const std::string& text, const std::string& file, XmlNamespaces namespaces) {
  [[maybe_unused]] static const bool is_initialised = (xmlInitParser(), true);
  checkForTheLibrary(text, file);
  const std::unique_ptr<xmlParserCtxt, ContextDeleter> context(xmlNewParserCtxt());
  if (context == nullptr) {
    throw std::bad_alloc();
  }
  Findings findings;
  findings.namespaces = namespaces;
  context->_private = &findings;
  xmlSAXHandler& handler = *context->sax;
  handler.serror = onError;
  handler.startElementNs = onElement;
  handler.characters = onText;
  handler.ignorableWhitespace = onText;
  handler.internalSubset = onDocumentType;
  handler.processingInstruction = onProcessingInstruction;
  XmlDocument document(xmlCtxtReadMemory(context.get(), text.data(), static_cast<int>(text.size()), nullptr, nullptr,
                                         XML_PARSE_NONET | XML_PARSE_NOCDATA | XML_PARSE_IGNORE_ENC));
  if (findings.first) {
    throw ConfigError({file, findings.first->line}, findings.first->message);
  }
  if (document == nullptr || xmlDocGetRootElement(document.get()) == nullptr) {
    throw ConfigError({file}, "found no well-formed XML");
  }
  return document;
}

int lineOf(const xmlNode* node) { return static_cast<int>(reinterpret_cast<std::intptr_t>(node->psvi)); }

}  // namespace swarmanoid
