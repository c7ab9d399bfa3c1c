#include "view/movie.hpp"

#include "io/file_errors.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <vector>

namespace clack::view {

namespace {

/// The same frames give the same file: one thread, and no name of the encoder in it.
std::vector<std::string> encoder_words(std::string const& output, PixelSize size, int frame_rate) {
    return {"ffmpeg",
            "-v",
            "error",
            "-nostdin",
            "-y",
            "-f",
            "rawvideo",
            "-pix_fmt",
            "rgb24",
            "-video_size",
            fmt::format("{}x{}", size.width, size.height),
            "-framerate",
            std::to_string(frame_rate),
            "-i",
            "-",
            "-c:v",
            "libx264",
            "-preset",
            "medium",
            "-crf",
            "18",
            "-pix_fmt",
            "yuv420p",
            "-threads",
            "1",
            "-fflags",
            "+bitexact",
            "-flags:v",
            "+bitexact",
            "-movflags",
            "+faststart",
            "-f",
            "mp4",
            output};
}

} // namespace

Movie::Movie(std::string const& path, PixelSize size, int frame_rate)
    : path_(path), temporary_(path) {
    std::signal(SIGPIPE, SIG_IGN); // an encoder that dies is an error of writing
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
        throw WriteError(path + ": no pipe to ffmpeg: " + std::strerror(errno));
    auto words = encoder_words(temporary_.name(), size, frame_rate);
    std::vector<char*> arguments;
    for (auto& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    int const failure =
        posix_spawnp(&encoder_, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[0]);
    pipe_ = ends[1];
    if (failure != 0) {
        close(pipe_);
        throw InputError("movie = " + path + ": ffmpeg cannot be started (" +
                         std::strerror(failure) + "); install ffmpeg");
    }
}

Movie::~Movie() {
    if (pipe_ >= 0) wait();
}

int Movie::wait() {
    close(pipe_);
    pipe_ = -1;
    int status = 0;
    while (waitpid(encoder_, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

void Movie::add(Pixels const& frame) {
    std::size_t written = 0;
    while (written < frame.rgb.size()) {
        auto const count = write(pipe_, frame.rgb.data() + written, frame.rgb.size() - written);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) throw WriteError(path_ + ": cannot be written: ffmpeg broke off");
        written += static_cast<std::size_t>(count);
    }
}

void Movie::finish() {
    if (wait() != 0) throw WriteError(path_ + ": cannot be written: ffmpeg failed");
    temporary_.move_into_place();
}

} // namespace clack::view
