#include "frame_files.hpp"

namespace swarmanoid {

FrameFiles::FrameFiles(const RunContext& context, const Configuration& parameters, const std::string& id)
    : out_(context.out != nullptr ? context.out : std::make_shared<OutFolder>()) {
  const bool is_in_experiment = context.asked_by.empty();
  writer_ = {is_in_experiment ? parameters.name() + " '" + id + "'" : context.asked_by, parameters.location(),
             is_in_experiment, "frame_directory"};
  const std::string folder = parameters.text("frame_directory", "");
  if (!folder.empty()) {
    out_->makeFolder(folder, writer_);
  }
  writer_.parameter = "frame_filename";
  begin_ = (folder.empty() ? "" : folder + "/") + parameters.text("frame_filename", "frame_");
  next_ = open();
  if (context.out == nullptr) {
    out_->keep();
  }
}

OutDescriptor FrameFiles::open() const {
  constexpr std::size_t kDigits = 6;
  const std::string number = std::to_string(count_);
  const std::string zeros(number.size() < kDigits ? kDigits - number.size() : 0, '0');
  return out_->open(begin_ + zeros + number + ".png", writer_);
}

void FrameFiles::write(const std::vector<char>& png) {
  if (!next_.isOpen()) {
    next_ = open();
    out_->keep();  // the run has begun: what it writes stays
  }
  next_.truncate(0);
  next_.write(png.data(), png.size());
  next_ = {};
  ++count_;
}

}  // namespace swarmanoid
