#include "pushback/common/render/image.h"

#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <algorithm>
#include <climits>
#include <fstream>
#include <iterator>
#include <memory>
#include <new>
#include <system_error>

#include "pushback/common/basics/input.h"

namespace pushback {
namespace {

constexpr int longest_side = 16384;

void require_size(int width, int height) {
  if (width < 1 || height < 1 || width > longest_side || height > longest_side) {
    throw InvalidInput(
        fmt::format("an image of {} x {} pixels is asked for: each side is from 1 to {}", width, height, longest_side));
  }
}

/// A file that goes away again unless it is given its final name.
class Draft {
 public:
  explicit Draft(const std::filesystem::path& file) : file_(file), draft_(file) { draft_ += ".part"; }
  ~Draft() {
    std::error_code ignored;
    if (!kept_) std::filesystem::remove(draft_, ignored);
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  bool write(const std::vector<char>& bytes) {
    std::ofstream out(draft_, std::ios::binary | std::ios::trunc);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    return !out.fail();
  }
  bool keep() {
    std::error_code failure;
    std::filesystem::rename(draft_, file_, failure);
    kept_ = !failure;
    return kept_;
  }

 private:
  std::filesystem::path file_, draft_;
  bool kept_ = false;
};

}  // namespace

Image::Image(int wide, int high, std::uint8_t level) : width(wide), height(high) {
  require_size(wide, high);
  pixels.assign(4 * static_cast<std::size_t>(wide) * static_cast<std::size_t>(high), level);
}

void write_png(const std::filesystem::path& file, const Image& image) {
  require_size(image.width, image.height);
  std::vector<std::uint8_t> rgb;
  rgb.reserve(image.pixels.size() / 4 * 3);
  for (auto pixel = image.pixels.begin(); pixel != image.pixels.end(); pixel += 4)
    rgb.insert(rgb.end(), pixel, pixel + 3);
  stbi_write_force_png_filter = 0;  // half the time for a few percent more bytes
  std::vector<char> bytes;
  const auto gather = [](void* to, void* data, int count) {
    const char* start = static_cast<const char*>(data);
    auto& all = *static_cast<std::vector<char>*>(to);
    all.insert(all.end(), start, start + count);
  };
  if (!stbi_write_png_to_func(gather, &bytes, image.width, image.height, 3, rgb.data(), 3 * image.width)) {
    throw std::bad_alloc();
  }
  Draft draft(file);
  if (!draft.write(bytes) || !draft.keep()) {
    throw InvalidInput(fmt::format("{} cannot be written", file.string()));
  }
}

Image read_png(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (bytes.empty() || bytes.size() > INT_MAX) {
    throw InvalidInput(fmt::format("{} cannot be read: it is not there, or empty, or too long", file.string()));
  }
  const auto* start = reinterpret_cast<const unsigned char*>(bytes.data());
  const int length = static_cast<int>(bytes.size());
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(start, length, &width, &height, &channels)) {
    throw InvalidInput(fmt::format("{} cannot be read: {}", file.string(), stbi_failure_reason()));
  }
  Image image(width, height);
  const std::unique_ptr<unsigned char, void (*)(void*)> levels(
      stbi_load_from_memory(start, length, &width, &height, &channels, 4), stbi_image_free);
  if (!levels) throw InvalidInput(fmt::format("{} cannot be read: {}", file.string(), stbi_failure_reason()));
  std::copy_n(levels.get(), image.pixels.size(), image.pixels.begin());
  return image;
}

}  // namespace pushback
