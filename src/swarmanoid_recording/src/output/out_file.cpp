#include "swarmanoid_recording/output/out_file.hpp"

#include <algorithm>
#include <exception>
#include <locale>
#include <streambuf>
#include <utility>

#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_recording/output/out_folder.hpp"
#include "swarmanoid_space/space.hpp"
#include "swarmanoid_space/suite_version.hpp"

namespace swarmanoid {

class OutFile::Buffer final : public std::streambuf {
 public:
  void open(OutDescriptor file) { file_ = std::move(file); }
  bool isOpen() const { return file_.isOpen(); }

  void restart() {
    text_.clear();
    has_begun_ = false;
  }

  /// Stores the first exception for a later query, because a stream would swallow it.
  void write() {
    if (isOpen() && !is_lost_) {
      try {
        begin();
        file_.write(text_.data(), text_.size());
      } catch (...) {
        is_lost_ = true;
        problem_ = std::current_exception();
      }
    }
    text_.clear();
  }

  std::exception_ptr takeProblem() { return std::exchange(problem_, nullptr); }

 private:
  int_type overflow(int_type character) override {
    const char one = traits_type::to_char_type(character);
    xsputn(&one, 1);
    return traits_type::not_eof(character);
  }

  std::streamsize xsputn(const char* data, std::streamsize size) override {
    constexpr std::size_t kMuch = std::size_t{1} << 16U;
    text_.append(data, static_cast<std::size_t>(size));
    if (text_.size() >= kMuch) {
      write();
    }
    return size;
  }

  void begin() {
    if (!has_begun_) {
      file_.truncate(0);
      has_begun_ = true;
    }
  }

  OutDescriptor file_;
  std::string text_;
  bool has_begun_ = false;
  bool is_lost_ = false;
  std::exception_ptr problem_;
};

OutFile::OutFile() : std::ostream(nullptr), buffer_(std::make_unique<Buffer>()) {
  rdbuf(buffer_.get());
  imbue(std::locale::classic());
}

OutFile::~OutFile() = default;

void OutFile::open(const RunContext& context, const Configuration& parameters, const std::string& id) {
  buffer_->open(openOutFile(context, parameters, id));
  experiment_ = context.experiment;
}

void OutFile::describeRun(const Space& space) {
  if (experiment_ == nullptr) {
    return;
  }
  std::string line = experiment_->name + ", seed " + std::to_string(space.seed) + ", swarmanoid " + suiteVersion();
  const char* before = ", with ";
  for (const Override& override : experiment_->overrides) {
    line += before + override.path + "=" + override.value;
    before = ", ";
  }
  std::replace_if(
      line.begin(), line.end(), [](char letter) { return letter == '\n' || letter == '\r'; }, ' ');
  *this << "# " << line << '\n';
  described_ = &space;
}

void OutFile::describeEnd() {
  if (described_ != nullptr) {
    *this << "# ended after " << described_->tick << " ticks, state hash " << hashText(stateHash(*described_)) << '\n';
    described_ = nullptr;
  }
  flush();
}

bool OutFile::isOpen() const { return buffer_->isOpen(); }

void OutFile::restart() {
  buffer_->restart();
  described_ = nullptr;
}

void OutFile::flush() {
  buffer_->write();
  if (const std::exception_ptr problem = buffer_->takeProblem()) {
    std::rethrow_exception(problem);
  }
}

OutDescriptor openOutFile(const RunContext& context, const Configuration& parameters, const std::string& id) {
  const bool is_in_experiment = context.asked_by.empty();
  const std::string writer = is_in_experiment ? parameters.name() + " '" + id + "'" : context.asked_by;
  const OutFolder::Writer asks{writer, parameters.location(), is_in_experiment};
  if (context.out != nullptr) {
    return context.out->open(parameters.text("file"), asks);
  }
  OutFolder anywhere;
  OutDescriptor file = anywhere.open(parameters.text("file"), asks);
  anywhere.keep();
  return file;
}

}  // namespace swarmanoid
