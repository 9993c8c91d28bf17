#include "swarmanoid_experiment_files/xml/element_text.hpp"

namespace swarmanoid {

std::string xmlEscaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\t':
      case '\n':
      case '\r':
        result += "&#" + std::to_string(static_cast<int>(c)) + ";";  // in attributes XML would read them as spaces
        break;
      default:
        result += c;
    }
  }
  return result;
}

void ElementText::begin(const std::string& name) {
  if (is_tag_open_) {
    text_ += ">\n";
  }
  indent();
  text_ += "<" + name;
  open_.push_back(name);
  is_tag_open_ = true;
}

void ElementText::attribute(const std::string& name, const std::string& value) {
  text_ += " " + name + "=\"" + xmlEscaped(value) + "\"";
}

void ElementText::end() {
  const std::string name = open_.back();
  open_.pop_back();
  if (is_tag_open_) {
    text_ += "/>\n";
    is_tag_open_ = false;
    return;
  }
  indent();
  text_ += "</" + name + ">\n";
}

void ElementText::end(const std::string& value) {
  text_ += ">" + xmlEscaped(value) + "</" + open_.back() + ">\n";
  open_.pop_back();
  is_tag_open_ = false;
}

void ElementText::value(const std::string& name, const std::string& text) {
  begin(name);
  end(text);
}

void ElementText::indent() { text_.append(2 * (static_cast<std::size_t>(depth_) + open_.size()), ' '); }

}  // namespace swarmanoid
