#include "swarmanoid_recording/records/record_folder.hpp"

#include <filesystem>

namespace swarmanoid {

RecordFolder::RecordFolder(OutFolder& out, const std::string& folder, const OutFolder::Writer& writer,
                           const RunRecord& record) {
  const std::filesystem::path path(folder);
  out.makeFolder(folder, writer);
  if (!record.files.empty()) {
    out.makeFolder((path / record_files::kNamedFiles).string(), writer);
  }
  for (RecordedFile& document : documentsOf(record)) {
    documents_.emplace_back(out.open((path / document.name).string(), writer), std::move(document.content));
  }
  result_ = out.open((path / record_files::kResult).string(), writer);
}

void RecordFolder::begin() {
  result_.truncate(0);
  for (auto& [file, content] : documents_) {
    file.truncate(0);
    file.write(content.data(), content.size());
  }
  documents_.clear();
}

void RecordFolder::finish(const std::string& result) { result_.write(result.data(), result.size()); }

}  // namespace swarmanoid
