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

Pixels stacked(std::vector<Pixels> const& pictures) {
    Pixels all{{pictures.front().size.width, 0}, {}};
    for (Pixels const& picture : pictures) {
        all.size.height += picture.size.height;
        all.rgb.insert(all.rgb.end(), picture.rgb.begin(), picture.rgb.end());
    }
    return all;
}

} // namespace clack::view
