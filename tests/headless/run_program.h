// Runs a built program and keeps what it says.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace slicecast {

// A scene that has everything.
inline const std::string kEveryFeature = SLICECAST_SOURCE_FOLDER "/tests/scene/everything.json";

struct Finished {
    int status = -1;  // exit status; -1 if it was ended by a signal
    std::string out;
    std::string err;
};

// `output`, if given, is where the standard output goes, as a shell takes it: "/dev/full" or "&9";
// then nothing of it is kept.
Finished runProgram(const std::string& program, const std::vector<std::string>& arguments,
                    const std::string& output = {});

// How many characters of a text steer a terminal; ends of lines do not count.
int controlCharacters(const std::string& text);

std::string readText(const std::filesystem::path& path);
void writeText(const std::filesystem::path& path, const std::string& text);

// A folder of its own for the running test, empty at first and gone with this.
class TestFolder {
public:
    TestFolder();
    ~TestFolder();
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    // The names of what is in it, sorted.
    std::vector<std::string> names() const;

private:
    std::filesystem::path path_;
};

}  // namespace slicecast
