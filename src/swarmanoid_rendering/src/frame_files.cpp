#include "frame_files.hpp"

namespace swarmanoid {
namespace {

constexpr const char* kEnding = ".png";

}  // namespace

FrameFiles::FrameFiles(const RunContext& context, const Configuration& parameters, const std::string& id)
    : out_(context.out != nullptr ? context.out : std::make_shared<OutFolder>()) {
  const bool is_in_experiment = context.asked_by.empty();
  writer_ = {is_in_experiment ? parameters.name() + " '" + id + "'" : context.asked_by, parameters.location(),
             is_in_experiment, "frame_directory"};
  const std::string folder = parameters.text("frame_directory", "");
  if (!folder.empty() || !is_in_experiment) {
    out_->makeFolder(folder, writer_);
  }
  writer_.parameter = "frame_filename";
  begin_ = (folder.empty() ? "" : folder + "/") + parameters.text("frame_filename", "frame_");
  out_->promiseSeries(begin_, kEnding, writer_);
  if (context.out == nullptr) {
    out_->keep();
  }
}

std::string FrameFiles::nameOf(std::size_t number) const {
  constexpr std::size_t kDigits = 6;
  const std::string digits = std::to_string(number);
  const std::string zeros(digits.size() < kDigits ? kDigits - digits.size() : 0, '0');
  return begin_ + zeros + digits + kEnding;
}

void FrameFiles::write(const std::vector<char>& png) {
  out_->writeWhole(nameOf(count_), writer_, png);
  ++count_;
}

}  // namespace swarmanoid
