/// Text files, written whole or not at all, and quoted text.
#pragma once

#include <filesystem>
#include <string>

namespace pushback {

/// Makes the folder of --out, with its parents. Throws InvalidInput if it cannot be made or written to.
void make_writable_folder(const std::filesystem::path& folder);
/// Writes a temporary file next to `file` and renames it when it is whole. Throws InvalidInput, naming the file, if that fails.
void write_text_file(const std::filesystem::path& file, const std::string& text);
/// Throws InvalidInput, naming the file and the reason, if write_text_file would. Call it before a long computation.
void require_writable_file(const std::filesystem::path& file);
/// The whole text. Throws InvalidInput, naming the file, if it cannot be read.
std::string read_text_file(const std::filesystem::path& file);
/// A temporary folder, which the destructor removes with its contents. Throws std::runtime_error if none can be made.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path path;
};

/// The text in double quotes, with quotes and backslashes escaped as gnuplot and JSON read them.
std::string quoted(const std::string& text);

}  // namespace pushback
