/// Text files, whole or not at all; text in quotes.
#pragma once

#include <filesystem>
#include <string>

namespace pushback {

/// The folder that --out leads to, with all above it. Throws InvalidInput where it cannot be made or written to.
void make_writable_folder(const std::filesystem::path& folder);
/// Written beside its place and moved there when whole. Throws InvalidInput, naming the file, where that fails.
void write_text_file(const std::filesystem::path& file, const std::string& text);
/// Throws InvalidInput, naming the file and the reason, where write_text_file would: to call before a long piece of work.
void require_writable_file(const std::filesystem::path& file);
/// All of it. Throws InvalidInput, naming the file, where it cannot be read.
std::string read_text_file(const std::filesystem::path& file);
/// A folder for files that nobody keeps: it is gone with this. Throws std::runtime_error where none can be made.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path path;
};

/// In double quotes, with quotes and backslashes escaped: as gnuplot and JSON read it.
std::string quoted(const std::string& text);

}  // namespace pushback
