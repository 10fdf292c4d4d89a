#include "pushback/common/render/image.h"

#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdlib>
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

/// A temporary file, which is removed unless `keep` gives it its final name.
class Draft {
 public:
  explicit Draft(const std::filesystem::path& file) : file_(file), draft_(file) { draft_ += ".part"; }
  ~Draft() {
    std::error_code ignored;
    if (!kept_) std::filesystem::remove(draft_, ignored);
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  bool write(const std::string& bytes) {
    std::ofstream out(draft_, std::ios::binary | std::ios::trunc);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    return !out.fail();
  }
  bool keep() {
    std::error_code failure;
    std::filesystem::rename(draft_, file_, failure);
    kept_ = !failure;
    errno = failure.value();
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

Difference difference(const Image& a, const Image& b, int block, int clearly) {
  if (a.width != b.width || a.height != b.height) {
    throw InvalidInput(fmt::format("images of {} x {} and {} x {} pixels are compared: one size is needed", a.width,
                                   a.height, b.width, b.height));
  }
  Difference d;
  for (int top = 0; top < a.height; top += block) {
    for (int left = 0; left < a.width; left += block) {
      const int bottom = std::min(top + block, a.height), right = std::min(left + block, a.width);
      const int count = (bottom - top) * (right - left);
      int worst = 0;
      for (int channel = 0; channel < 3; ++channel) {
        int apart = 0;
        for (int y = top; y < bottom; ++y) {
          for (int x = left; x < right; ++x) apart += a.at(x, y)[channel] - b.at(x, y)[channel];
        }
        d.mean += std::abs(apart);
        worst = std::max(worst, std::abs(apart));
      }
      d.share += worst > clearly * count ? count : 0;
    }
  }
  const double pixels = static_cast<double>(a.width) * a.height;
  return {d.mean / (3 * pixels), d.share / pixels};
}

std::string in_png(const Image& image) {
  require_size(image.width, image.height);
  std::vector<std::uint8_t> rgb;
  rgb.reserve(image.pixels.size() / 4 * 3);
  for (auto pixel = image.pixels.begin(); pixel != image.pixels.end(); pixel += 4)
    rgb.insert(rgb.end(), pixel, pixel + 3);
  stbi_write_force_png_filter = 0;  // half the time for a few percent more bytes
  std::string bytes;
  const auto gather = [](void* to, void* data, int count) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), static_cast<std::size_t>(count));
  };
  if (!stbi_write_png_to_func(gather, &bytes, image.width, image.height, 3, rgb.data(), 3 * image.width)) {
    throw std::bad_alloc();
  }
  return bytes;
}

void write_png(const std::filesystem::path& file, const Image& image) {
  const std::string bytes = in_png(image);
  Draft draft(file);
  if (!draft.write(bytes) || !draft.keep()) {
    throw InvalidInput(fmt::format("{} cannot be written: {}", file.string(), std::generic_category().message(errno)));
  }
}

Image read_png(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return from_png({std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()}, file.string());
}

Image from_png(const std::string& bytes, const std::string& name) {
  if (bytes.empty() || bytes.size() > INT_MAX) {
    throw InvalidInput(fmt::format("{} cannot be read: it is not there, or empty, or too long", name));
  }
  const auto* start = reinterpret_cast<const unsigned char*>(bytes.data());
  const int length = static_cast<int>(bytes.size());
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(start, length, &width, &height, &channels)) {
    throw InvalidInput(fmt::format("{} cannot be read: {}", name, stbi_failure_reason()));
  }
  Image image(width, height);
  const std::unique_ptr<unsigned char, void (*)(void*)> levels(
      stbi_load_from_memory(start, length, &width, &height, &channels, 4), stbi_image_free);
  if (!levels) throw InvalidInput(fmt::format("{} cannot be read: {}", name, stbi_failure_reason()));
  std::copy_n(levels.get(), image.pixels.size(), image.pixels.begin());
  return image;
}

}  // namespace pushback
