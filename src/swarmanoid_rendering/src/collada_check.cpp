// What assimp's reader of Collada does not check: indices into arrays, counts that memory is reserved for, references
// that lead back to where they started.
#include <algorithm>
#include <charconv>
#include <map>
#include <set>
#include <stdexcept>
#include <vector>

#include "mesh_checks.hpp"
#include "xml_tags.hpp"

namespace swarmanoid {
namespace {

constexpr std::size_t kMostNodes = 100000;  // drawn, with all copies
constexpr std::size_t kMostOffset = 1000;   // of an input among those of a corner

std::string quoted(std::string_view text) {
  constexpr std::size_t kLongest = 100;
  return "'" + std::string(text.substr(0, kLongest)) + (text.size() > kLongest ? "..." : "") + "'";
}

[[noreturn]] void refuse(int line, const std::string& problem) {
  throw std::runtime_error("line " + std::to_string(line) + ": found " + problem);
}

/// Calls `take` for each word of a text.
template <class Take>
void forWords(std::string_view text, Take take) {
  std::size_t begin = 0;
  while ((begin = text.find_first_not_of(" \t\r\n", begin)) != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(" \t\r\n", begin), text.size());
    take(text.substr(begin, end - begin));
    begin = end;
  }
}

/// A cycle cannot be hidden behind another spelling of a letter: references to signs by number are refused.
std::string_view attributeOf(const XmlTag& tag, std::string_view name) {
  const auto found = tag.attributes.find(name);
  if (found == tag.attributes.end()) {
    return {};
  }
  if (found->second.find("&#") != std::string_view::npos) {
    refuse(tag.line, std::string(name) + "=" + quoted(found->second) + " of <" + std::string(tag.name) +
                         ">, allowed: a text without '&#'");
  }
  return found->second;
}

std::size_t numberIn(std::string_view word, const std::string& what, int line, std::size_t most) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || value > most) {
    refuse(line, what + " " + quoted(word) + ", allowed: a whole number from 0 to " + std::to_string(most));
  }
  return value;
}

class ColladaCheck {
 public:
  explicit ColladaCheck(const std::string& text) : tags_(text), most_(text.size()) {}

  void run() {
    XmlTag tag;
    while (tags_.next(tag)) {
      if (tag.kind == XmlTag::Kind::kOpening) {
        open(tag);
      } else if (tag.name == "node" && !around_.empty()) {
        around_.pop_back();
      } else if (tag.name == shape_.name) {
        closeShape(tag.line);
      } else if (tag.name == "effect") {
        checkReferences(tag.line);
      }
    }
    checkAccessors();
    checkNodes();
  }

 private:
  struct Array {
    std::size_t count = 0;
    bool has_numbers = false;
  };
  struct Accessor {
    int line = 0;
    std::string_view source;
    std::size_t count = 0, stride = 1, offset = 0, parameters = 0;
  };
  struct Shape {
    std::string_view name;
    std::size_t count = 0;  ///< of faces, as the file says
    std::size_t width = 1;  ///< indices of a corner
    std::size_t lists = 0;  ///< of indices
    bool has_corners = false;
  };
  struct Node {
    int line = 0;
    std::vector<std::size_t> children;
    std::vector<std::string_view> copied;  ///< ids or names
    std::size_t size = 0;                  ///< nodes that are drawn; 0: not known yet
    bool is_entered = false;
    bool is_nested = false;
  };

  std::size_t numberOf(const XmlTag& tag, const char* name, std::size_t fallback, std::size_t most) const {
    const std::string what = std::string(name) + " of <" + std::string(tag.name) + ">";
    return tag.attributes.count(name) == 0 ? fallback : numberIn(attributeOf(tag, name), what, tag.line, most);
  }

  static std::string_view textOf(const XmlTag& tag) {
    if (!tag.has_only_text) {
      refuse(tag.line, "more than a text in <" + std::string(tag.name) + ">, allowed: values");
    }
    return tag.text;
  }

  void open(const XmlTag& tag) {
    static const std::set<std::string_view> kShapes{"triangles",  "polylist", "polygons", "lines",
                                                    "linestrips", "trifans",  "tristrips"};
    if (tag.name == "float_array" || tag.name == "int_array" || tag.name == "bool_array" || tag.name == "Name_array" ||
        tag.name == "IDREF_array") {
      openArray(tag);
    } else if (tag.name == "accessor") {
      accessors_.push_back({tag.line, attributeOf(tag, "source"), numberOf(tag, "count", 0, most_),
                            numberOf(tag, "stride", 1, most_), numberOf(tag, "offset", 0, most_), 0});
    } else if (tag.name == "param" && tags_.open().size() > 1 && *(tags_.open().end() - 2) == "accessor") {
      ++accessors_.back().parameters;
    } else if (kShapes.count(tag.name) != 0) {
      shape_ = Shape{tag.name, numberOf(tag, "count", 0, most_)};
    } else if (tag.name == "input") {
      shape_.width = std::max(shape_.width, numberOf(tag, "offset", 0, kMostOffset) + 1);
    } else if (tag.name == "p") {
      openIndices(tag);
    } else if (tag.name == "vcount") {
      openCorners(tag);
    } else if (tag.name == "controller" || tag.name == "animation") {
      refuse(tag.line, "<" + std::string(tag.name) + ">, allowed: bodies that neither bend nor move by themselves");
    } else if (tag.name == "node") {
      openNode(tag);
    } else if (tag.name == "instance_node") {
      const std::string_view url = attributeOf(tag, "url");
      if (!around_.empty()) {
        nodes_[around_.back()].copied.push_back(url.substr(url.empty() ? 0 : 1));
      }
    } else if (tag.name == "newparam") {
      parameter_ = attributeOf(tag, "sid");
    } else if ((tag.name == "source" || tag.name == "init_from") && isIn("newparam")) {
      references_[std::string(parameter_)] = std::string(textOf(tag));
    }
  }

  bool isIn(std::string_view element) const {
    const auto& open = tags_.open();
    return std::find(open.begin(), open.end(), element) != open.end();
  }

  void openArray(const XmlTag& tag) {
    Array array;
    array.has_numbers = tag.name == "float_array";
    array.count = numberOf(tag, "count", 0, most_);
    std::size_t values = 0;
    forWords(textOf(tag), [&](std::string_view) { ++values; });
    if (array.count > values) {
      refuse(tag.line, "count '" + std::to_string(array.count) + "' of <" + std::string(tag.name) +
                           ">, allowed: " + std::to_string(values) + ", as many as there are");
    }
    const std::string_view id = attributeOf(tag, "id");
    if (!id.empty() && !arrays_.emplace(id, array).second) {
      refuse(tag.line, "a second array with the id " + quoted(id) + ", allowed: one");
    }
  }

  void openIndices(const XmlTag& tag) {
    if (shape_.name == "polylist" && !shape_.has_corners) {
      refuse(tag.line, "<p> without <vcount> before it, allowed: after the numbers of corners");
    }
    std::size_t indices = 0;
    forWords(textOf(tag), [&](std::string_view word) {
      numberIn(word, "an index", tag.line, most_);  // the library waits for ever behind another word
      ++indices;
    });
    const auto& open = tags_.open();
    shape_.lists += indices > 0 && open.size() > 1 && *(open.end() - 2) == shape_.name ? 1 : 0;
    if ((shape_.name == "trifans" || shape_.name == "tristrips") && indices < 3 * shape_.width) {
      refuse(tag.line, std::to_string(indices) + " indices in <" + std::string(shape_.name) + ">, allowed: at least " +
                           std::to_string(3 * shape_.width) + ", for three corners");
    }
  }

  /// Another number of lists fails an assertion of the library.
  void closeShape(int line) {
    const bool has_one_list = shape_.name == "triangles" || shape_.name == "polylist";
    const std::size_t lists = has_one_list ? std::min<std::size_t>(shape_.count, 1) : shape_.count;
    if ((has_one_list || shape_.name == "polygons") && shape_.lists != lists) {
      refuse(line, std::to_string(shape_.lists) + " <p> with indices in <" + std::string(shape_.name) + "> of count " +
                       std::to_string(shape_.count) + ", allowed: " + std::to_string(lists));
    }
    shape_ = Shape{};
  }

  void openCorners(const XmlTag& tag) {
    shape_.has_corners = true;
    std::size_t corners = 0;
    forWords(textOf(tag),
             [&](std::string_view word) { corners += numberIn(word, "a number of corners", tag.line, kMostCorners); });
    if (corners > most_) {
      refuse(tag.line, std::to_string(corners) + " corners, allowed: as many as there are");
    }
  }

  void openNode(const XmlTag& tag) {
    const std::size_t index = nodes_.size();
    nodes_.emplace_back();
    nodes_.back().line = tag.line;
    if (!around_.empty()) {
      nodes_[around_.back()].children.push_back(index);
      nodes_.back().is_nested = true;
    }
    around_.push_back(index);
    for (const char* const key : {"id", "name", "sid"}) {
      if (const std::string_view name = attributeOf(tag, key); !name.empty()) {
        named_[name].push_back(index);
      }
    }
  }

  void checkAccessors() const {
    for (const Accessor& accessor : accessors_) {
      const auto found = arrays_.find(accessor.source.substr(accessor.source.empty() ? 0 : 1));
      if (found == arrays_.end()) {
        continue;  // the library reports it
      }
      const Array& array = found->second;
      if (!array.has_numbers) {
        refuse(accessor.line, "an accessor of " + quoted(accessor.source) + ", allowed: of a <float_array>");
      }
      const std::size_t left = array.count - std::min(accessor.offset, array.count);
      if (accessor.stride == 0 || accessor.count > left / accessor.stride || accessor.parameters > accessor.stride) {
        refuse(accessor.line, "an accessor of " + std::to_string(accessor.count) + " times " +
                                  std::to_string(accessor.stride) + " values from " + std::to_string(accessor.offset) +
                                  " on, allowed: those of its array, which has " + std::to_string(array.count));
      }
    }
  }

  void checkNodes() {
    std::size_t all = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      all += nodes_[i].is_nested ? 0 : sizeOf(i);
      refuseMany(i, all);
    }
  }

  void refuseMany(std::size_t index, std::size_t nodes) const {
    if (nodes > kMostNodes) {
      refuse(nodes_[index].line, "more than " + std::to_string(kMostNodes) + " nodes with all copies, allowed: fewer");
    }
  }

  // NOLINTNEXTLINE(misc-no-recursion): not deeper than kDeepest
  std::size_t sizeOf(std::size_t index, std::size_t depth = 0) {
    constexpr std::size_t kDeepest = 1000;
    if (nodes_[index].size > 0) {
      return nodes_[index].size;
    }
    if (nodes_[index].is_entered || depth > kDeepest) {
      refuse(nodes_[index].line, "a node that is copied into itself, or in more than " + std::to_string(kDeepest) +
                                     " steps, allowed: neither");
    }
    nodes_[index].is_entered = true;
    std::vector<std::size_t> parts = nodes_[index].children;
    for (const std::string_view name : nodes_[index].copied) {
      if (const auto found = named_.find(name); found != named_.end()) {
        parts.insert(parts.end(), found->second.begin(), found->second.end());
      }
    }
    std::size_t size = 1;
    for (const std::size_t part : parts) {
      size += sizeOf(part, depth + 1);
      refuseMany(index, size);
    }
    return nodes_[index].size = size;
  }

  /// Parameters of an effect name each other until one names an image.
  void checkReferences(int line) {
    for (const auto& [first, reference] : references_) {
      std::size_t steps = 0;
      for (auto at = references_.find(first); at != references_.end(); at = references_.find(at->second)) {
        if (++steps > references_.size()) {
          refuse(line,
                 "the parameter " + quoted(first) + " of an effect, which leads back to itself, allowed: an image");
        }
      }
    }
    references_.clear();
  }

  XmlTags tags_;
  std::size_t most_;  ///< of what needs a byte of the file each
  std::map<std::string_view, Array> arrays_;
  std::vector<Accessor> accessors_;
  Shape shape_;  ///< around what is read
  std::vector<Node> nodes_;
  std::map<std::string_view, std::vector<std::size_t>> named_;
  std::vector<std::size_t> around_;  ///< nodes that are open
  std::string_view parameter_;
  std::map<std::string, std::string> references_;
};

}  // namespace

void checkCollada(const std::string& text) { ColladaCheck(text).run(); }

}  // namespace swarmanoid
