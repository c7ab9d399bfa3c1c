#pragma once
// A movie in a file: frames handed to ffmpeg.

#include "io/output_file.hpp"
#include "view/canvas.hpp"

#include <sys/types.h>

#include <string>

namespace clack::view {

class Movie {
public:
    /// Throws InputError when there is no ffmpeg.
    Movie(std::string const& path, PixelSize size, int frame_rate);
    Movie(Movie const&) = delete;
    Movie& operator=(Movie const&) = delete;
    ~Movie();

    void add(Pixels const& frame);
    /// The file appears now. Throws WriteError when ffmpeg failed.
    void finish();

private:
    int wait();

    std::string path_;
    TemporaryName temporary_;
    pid_t encoder_ = -1;
    int pipe_ = -1;
};

} // namespace clack::view
