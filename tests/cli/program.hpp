#pragma once
// The program as its users meet it: started, watched, killed.

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

namespace clack::test {

/// A folder of its own for each test program, gone at its end.
class Folder {
public:
    Folder() {
        std::filesystem::create_directories(path_);
        std::filesystem::current_path(path_);
    }
    Folder(Folder const&) = delete;
    Folder& operator=(Folder const&) = delete;
    ~Folder() { std::filesystem::remove_all(path_); }

    /// Writes a text and returns its path.
    std::string write(std::string const& name, std::string const& text) const {
        std::ofstream(path_ / name) << text;
        return file(name);
    }
    std::string file(std::string const& name) const { return (path_ / name).string(); }
    /// Names of all files, hidden ones too.
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (auto const& entry : std::filesystem::directory_iterator(path_)) {
            all.push_back(entry.path().filename().string());
        }
        return all;
    }

private:
    std::filesystem::path path_ =
        std::filesystem::temp_directory_path() / ("clack-test-cli-" + std::to_string(getpid()));
};

inline std::string text_of(std::string const& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

struct Outcome {
    int code = 0;          // of exit; minus the signal's number for a process that it ended
    double peak_bytes = 0; // of memory that the process had at once
    std::string out, err;

    bool err_is_one_line() const { return !err.empty() && err.find('\n') == err.size() - 1; }
};

/// One process of the program, its output in files that only this process reads.
class Process {
public:
    explicit Process(std::vector<std::string> arguments,
                     std::vector<std::string> const& prefix = {}) {
        auto words = prefix;
        words.push_back(CLACK_PROGRAM);
        words.insert(words.end(), arguments.begin(), arguments.end());
        child_ = fork();
        if (child_ == 0) replace_by(words);
    }
    Process(Process const&) = delete;
    Process& operator=(Process const&) = delete;

    /// Waits for a file that the process makes, so that a slow machine gets as far as a quick one.
    void wait_for(std::filesystem::path const& file) const {
        for (int k = 0; k < 60'000 && !std::filesystem::exists(file); ++k)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }

    void signal_after(std::chrono::microseconds wait, int number) {
        std::this_thread::sleep_for(wait);
        kill(child_, number);
    }

    Outcome finish() {
        int status = 0;
        rusage used{};
        wait4(child_, &status, 0, &used);
        Outcome outcome;
        outcome.peak_bytes = 1024.0 * static_cast<double>(used.ru_maxrss);
        outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
        outcome.out = text_of(out_);
        outcome.err = text_of(err_);
        std::filesystem::remove(out_);
        std::filesystem::remove(err_);
        return outcome;
    }

private:
    [[noreturn]] void replace_by(std::vector<std::string>& words) const {
        std::vector<char*> pointers;
        for (auto& word : words) pointers.push_back(word.data());
        pointers.push_back(nullptr);
        redirect(out_, STDOUT_FILENO);
        redirect(err_, STDERR_FILENO);
        execvp(pointers[0], pointers.data());
        _exit(127);
    }
    static void redirect(std::string const& path, int descriptor) {
        dup2(open(path.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600), descriptor);
    }
    static std::string unique(std::string const& kind) {
        static int number = 0;
        return (std::filesystem::temp_directory_path() /
                ("clack-test-" + kind + "-" + std::to_string(getpid()) + "-" +
                 std::to_string(++number)))
            .string();
    }

    std::string out_ = unique("out"), err_ = unique("err");
    pid_t child_;
};

inline Outcome run_clack(std::vector<std::string> const& arguments,
                         std::vector<std::string> const& prefix = {}) {
    return Process(arguments, prefix).finish();
}

} // namespace clack::test
