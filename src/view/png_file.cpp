#include "view/png_file.hpp"

#include "io/file_errors.hpp"
#include "io/output_file.hpp"

#include <png.h>

namespace clack::view {

void write_png(std::string const& path, Pixels const& pixels) {
    TemporaryName temporary(path);
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(pixels.size.width);
    image.height = static_cast<png_uint_32>(pixels.size.height);
    image.format = PNG_FORMAT_RGB;
    if (!png_image_write_to_file(&image, temporary.name().c_str(), 0, pixels.rgb.data(), 0,
                                 nullptr)) {
        throw WriteError(path + ": cannot be written: " + image.message);
    }
    temporary.move_into_place();
}

Pixels joined(std::vector<Pixels> const& pictures) {
    constexpr int strip = 3; // times as wide as high
    auto const& one = pictures.front().size;
    auto const count = static_cast<int>(pictures.size());
    bool const below = one.width >= strip * one.height;
    Pixels all{{below ? one.width : count * one.width, below ? count * one.height : one.height},
               {}};
    auto const stride = 3 * static_cast<std::ptrdiff_t>(one.width);
    if (below) {
        for (Pixels const& picture : pictures)
            all.rgb.insert(all.rgb.end(), picture.rgb.begin(), picture.rgb.end());
        return all;
    }
    for (int row = 0; row < one.height; ++row) {
        for (Pixels const& picture : pictures) {
            auto const begin = picture.rgb.begin() + row * stride;
            all.rgb.insert(all.rgb.end(), begin, begin + stride);
        }
    }
    return all;
}

} // namespace clack::view
