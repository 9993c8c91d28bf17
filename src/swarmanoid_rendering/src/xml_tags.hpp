/// Iterates over the tags of a large XML text, in time proportional to its length and without copying it, for checks of
/// files before a library reads them.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace swarmanoid {

struct XmlTag {
  enum class Kind { kOpening, kClosing };

  Kind kind = Kind::kOpening;
  std::string_view name;
  std::map<std::string_view, std::string_view> attributes;  ///< raw, with references such as &amp;
  std::string_view text;                                    ///< of its element, up to the next tag or comment
  bool has_only_text = false;                               ///< the element is closed right after its text
  int line = 0;
};

class XmlTags {
 public:
  static constexpr std::size_t kMostNested = 200;

  /// @param text must outlive this object and all tags
  explicit XmlTags(std::string_view text) : text_(text) {}

  /// Reads the next tag; an element without content gives two. Comments and instructions are skipped.
  /// @return whether there was one
  /// @throws std::runtime_error "line N: found ..., allowed: ...": a document type, sections of characters,
  /// instructions in elements, deep nesting, tags that are not closed, a second root
  bool next(XmlTag& tag);

  /// Names of the open elements, outermost first.
  const std::vector<std::string_view>& open() const { return open_; }

 private:
  bool findTag();
  void skipPast(std::string_view end, const char* what);
  void skipInstruction();
  void readName(XmlTag& tag);
  void readAttributes(XmlTag& tag);
  void close(const XmlTag& tag);
  void skipSpace();
  [[noreturn]] void refuse(const std::string& problem);

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t counted_ = 0;  ///< end of the text whose lines are counted
  int line_ = 1;
  bool is_empty_element_ = false;  ///< its closing tag comes next
  bool has_root_ = false;          ///< the element around all others has begun
  std::vector<std::string_view> open_;
};

}  // namespace swarmanoid
