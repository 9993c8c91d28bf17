// Checks that assimp's reader of Collada lacks: indices into arrays, counts that it reserves memory for, circular
// references, elements that fail its assertions.
#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "collada_nodes.hpp"
#include "collada_parameters.hpp"
#include "collada_shapes.hpp"
#include "mesh_checks.hpp"
#include "xml_tags.hpp"
#include "xml_values.hpp"

namespace swarmanoid {
namespace {

constexpr std::size_t kMostParameters = 4;  // of an accessor; with more, assimp overruns its buffer

class ColladaCheck {
 public:
  explicit ColladaCheck(const std::string& text) : tags_(text), most_(text.size()), shapes_(text.size()) {}

  void run() {
    XmlTag tag;
    while (tags_.next(tag)) {
      if (tag.kind == XmlTag::Kind::kOpening) {
        open(tag);
      } else if (tag.name == "node" || tag.name == "visual_scene") {
        nodes_.close();
      } else if (tag.name == "effect") {
        parameters_.check(tag.line);
      } else {
        shapes_.close(tag);
      }
    }
    checkAccessors();
    nodes_.check(shapes_.corners());
  }

 private:
  struct Array {
    std::size_t count = 0;
    bool has_numbers = false;
  };
  struct Accessor {
    int line = 0;
    std::string source;
    std::size_t count = 0, stride = 1, offset = 0, parameters = 0;
  };

  void open(const XmlTag& tag) {
    refuseElements(tag);
    if (tags_.open().size() == 1) {
      is_version_14_ = attributeOf(tag, "version").substr(0, 3) == "1.4";
    } else if (tag.name == "ref" || (tag.name == "init_from" && is_version_14_)) {
      openPicture(tag);
    }
    if (tag.name == "float_array" || tag.name == "int_array" || tag.name == "bool_array" || tag.name == "Name_array" ||
        tag.name == "IDREF_array") {
      openArray(tag);
    } else if (tag.name == "accessor") {
      openAccessor(tag);
    } else if (tag.name == "param" && isIn("accessor")) {
      openParameter(tag);
    } else if (tag.name == "node" || tag.name == "visual_scene") {
      nodes_.open(tag, isInLibrary(tag));
    } else if (tag.name.substr(0, 9) == "instance_" && (parent() == "node" || parent() == "visual_scene")) {
      nodes_.instance(tag);
    } else if (tag.name == "newparam") {
      parameters_.open(tag);
    } else if (tag.name == "sampler2D" && isIn("newparam")) {
      parameters_.refer(attributeOf(tag, "url").erase(0, 1));
    } else if ((tag.name == "source" || tag.name == "init_from") && isIn("newparam")) {
      parameters_.refer(decoded(textOf(tag), tag.line, false));
    } else if (tag.name == "source") {
      openSource(tag);
    } else {
      shapes_.open(tag, parent());
    }
  }

  bool isIn(std::string_view element) const {
    const auto& open = tags_.open();
    return std::find(open.begin(), open.end(), element) != open.end();
  }

  std::string_view parent() const {
    const auto& open = tags_.open();
    return open.size() > 1 ? *(open.end() - 2) : std::string_view();
  }

  /// Whether assimp keeps this node, or scene, in its library of nodes.
  bool isInLibrary(const XmlTag& tag) const {
    const auto& open = tags_.open();
    return open.size() == 3 && open[0] == "COLLADA" &&
           open[1] == (tag.name == "node" ? "library_nodes" : "library_visual_scenes");
  }

  void refuseElements(const XmlTag& tag) const {
    static const std::set<std::string_view> kNotNested{"accessor", "effect", "geometry", "newparam"};
    static const std::map<std::string_view, const char*> kRefused{
        {"animation", "bodies that neither bend nor move by themselves"},
        {"animation_clip", "bodies that neither bend nor move by themselves"},
        {"controller", "bodies that neither bend nor move by themselves"},
        {"hex", "pictures in files of their own"},
        {"skew", "other transformations"}};
    const auto refuse = [&tag](const std::string& rest) {
      refuseAt(tag.line, "<" + std::string(tag.name) + ">" + rest);
    };
    if (const auto found = kRefused.find(tag.name); found != kRefused.end()) {
      refuse(std::string(", allowed: ") + found->second);
    }
    const auto& open = tags_.open();
    if (kNotNested.count(tag.name) != 0 && std::count(open.begin(), open.end(), tag.name) > 1) {
      refuse(" in another one, allowed: one after the other");
    }
  }

  void openArray(const XmlTag& tag) {
    Array array;
    array.has_numbers = tag.name == "float_array";
    array.count = numberOf(tag, "count", 0, most_);
    std::size_t values = 0;
    forWords(textOf(tag), [&](std::string_view) { ++values; });
    if (array.count > values) {
      refuseAt(tag.line, "count '" + std::to_string(array.count) + "' of <" + std::string(tag.name) +
                             ">, allowed: " + std::to_string(values) + ", as many as there are");
    }
    const std::string id = attributeOf(tag, "id");
    if (!id.empty() && !arrays_.emplace(id, array).second) {
      refuseAt(tag.line, "a second array with the id " + inQuotes(id) + ", allowed: one");
    }
  }

  void openAccessor(const XmlTag& tag) {
    const std::string source = attributeOf(tag, "source");
    if (source == "#") {  // assimp would resolve it to an array without an id
      refuseAt(tag.line, "source='#' of <accessor>, allowed: '#' and an id");
    }
    accessors_.push_back({tag.line, source.substr(source.empty() ? 0 : 1), numberOf(tag, "count", 0, most_),
                          numberOf(tag, "stride", 1, most_), numberOf(tag, "offset", 0, most_), 0});
  }

  void openParameter(const XmlTag& tag) {
    if (++accessors_.back().parameters > kMostParameters || attributeOf(tag, "type") == "float4x4") {
      refuseAt(tag.line, "more than " + std::to_string(kMostParameters) + " numbers in an <accessor>, allowed: fewer");
    }
  }

  /// Rejects a second source with the same id: assimp would drop the data of the first.
  void openSource(const XmlTag& tag) {
    const std::string id = attributeOf(tag, "id");
    if (!id.empty() && !sources_.insert(id).second) {
      refuseAt(tag.line, "a second <source> with the id " + inQuotes(id) + ", allowed: one");
    }
  }

  /// Rejects an empty file name: it fails an assertion of assimp.
  void openPicture(const XmlTag& tag) const {
    if (!isIn("image")) {
      return;
    }
    const std::string name = decoded(textOf(tag), tag.line, false);
    if (name == "file://" || name.find_first_not_of(" \t\r\n") == std::string::npos) {
      refuseAt(tag.line, "<" + std::string(tag.name) + "> without a name, allowed: the name of a picture");
    }
  }

  void checkAccessors() const {
    for (const Accessor& accessor : accessors_) {
      const auto found = arrays_.find(accessor.source);
      if (found == arrays_.end()) {
        continue;  // assimp reports it
      }
      const Array& array = found->second;
      if (!array.has_numbers) {
        refuseAt(accessor.line, "an accessor of " + inQuotes("#" + accessor.source) + ", allowed: of a <float_array>");
      }
      const std::size_t left = array.count - std::min(accessor.offset, array.count);
      if (accessor.stride == 0 || accessor.count > left / accessor.stride || accessor.parameters > accessor.stride) {
        refuseAt(accessor.line, "an accessor of " + std::to_string(accessor.count) + " times " +
                                    std::to_string(accessor.stride) + " values from " +
                                    std::to_string(accessor.offset) + " on, allowed: those of its array, which has " +
                                    std::to_string(array.count));
      }
    }
  }

  XmlTags tags_;
  bool is_version_14_ = false;  ///< since 1.5 image names are in <ref>
  std::size_t most_;            ///< upper bound of counts: each item needs a byte of the file
  std::map<std::string, Array> arrays_;
  std::set<std::string> sources_;
  std::vector<Accessor> accessors_;
  ColladaShapes shapes_;
  ColladaNodes nodes_;
  ColladaParameters parameters_;  ///< of the open effect
};

}  // namespace

void checkCollada(const std::string& text) { ColladaCheck(text).run(); }

}  // namespace swarmanoid
