#include "pushback/common/render/image.h"

#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <algorithm>
#include <climits>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <new>
#include <system_error>

#include "pushback/common/basics/input.h"
#include "pushback/common/render/light.h"

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

/// Which old pixels a new one covers along one axis, and how much of it each of them makes up.
struct Cover {
  int first = 0;
  std::vector<float> shares;  // their sum is 1
};

std::vector<Cover> covers(int before, int after) {
  std::vector<Cover> all(static_cast<std::size_t>(after));
  const double step = static_cast<double>(before) / after;
  for (int i = 0; i < after; ++i) {
    const double low = i * step, high = (i + 1) * step;
    Cover& cover = all[static_cast<std::size_t>(i)];
    cover.first = std::min(static_cast<int>(low), before - 1);
    for (int k = cover.first; k < before && (k < high || cover.shares.empty()); ++k) {
      const double share = (std::min<double>(high, k + 1) - std::max<double>(low, k)) / step;
      cover.shares.push_back(static_cast<float>(std::max(share, 0.0)));
    }
  }
  return all;
}

}  // namespace

Image::Image(int wide, int high, std::uint8_t level) : width(wide), height(high) {
  require_size(wide, high);
  pixels.assign(3 * static_cast<std::size_t>(wide) * static_cast<std::size_t>(high), level);
}

void write_png(const std::filesystem::path& file, const Image& image) {
  require_size(image.width, image.height);
  stbi_write_force_png_filter = 0;  // half the time for a few percent more bytes
  std::vector<char> bytes;
  const auto gather = [](void* to, void* data, int count) {
    const char* start = static_cast<const char*>(data);
    auto& all = *static_cast<std::vector<char>*>(to);
    all.insert(all.end(), start, start + count);
  };
  if (!stbi_write_png_to_func(gather, &bytes, image.width, image.height, 3, image.pixels.data(), 3 * image.width)) {
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
      stbi_load_from_memory(start, length, &width, &height, &channels, 3), stbi_image_free);
  if (!levels) throw InvalidInput(fmt::format("{} cannot be read: {}", file.string(), stbi_failure_reason()));
  std::copy_n(levels.get(), image.pixels.size(), image.pixels.begin());
  return image;
}

Image resized(const Image& image, int width, int height) {
  require_size(image.width, image.height);
  Image result(width, height);
  const std::vector<Cover> columns = covers(image.width, width), rows = covers(image.height, height);
  std::vector<float> line(3 * static_cast<std::size_t>(image.width));  // the covered rows, averaged
  for (int y = 0; y < height; ++y) {
    std::fill(line.begin(), line.end(), 0.0f);
    const Cover& row = rows[static_cast<std::size_t>(y)];
    for (std::size_t k = 0; k < row.shares.size(); ++k) {
      const std::uint8_t* from = image.at(0, row.first + static_cast<int>(k));
      for (std::size_t i = 0; i < line.size(); ++i) line[i] += row.shares[k] * linear_of(from[i]);
    }
    for (int x = 0; x < width; ++x) {
      const Cover& column = columns[static_cast<std::size_t>(x)];
      for (std::size_t channel = 0; channel < 3; ++channel) {
        float light = 0;
        for (std::size_t k = 0; k < column.shares.size(); ++k) {
          light += column.shares[k] * line[3 * (static_cast<std::size_t>(column.first) + k) + channel];
        }
        result.at(x, y)[channel] = level_of(light);
      }
    }
  }
  return result;
}

void paste(const Image& from, Image& onto, int x, int y) {
  const int left = std::max(0, x),
            right = static_cast<int>(std::min<long long>(onto.width, static_cast<long long>(x) + from.width));
  if (left >= right) return;
  for (int row = 0; row < from.height; ++row) {
    const long long target = static_cast<long long>(y) + row;
    if (target < 0 || target >= onto.height) continue;
    std::memcpy(onto.at(left, static_cast<int>(target)), from.at(left - x, row),
                3 * static_cast<std::size_t>(right - left));
  }
}

}  // namespace pushback
