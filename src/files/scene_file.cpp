#include "files/scene_file.h"

#include "files/read_file.h"
#include "scene/limits.h"
#include "scene/names.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace slicecast {
namespace {

LoadedScene notReadable(const std::string& file, const std::string& why) {
    Fault fault;
    fault.file = file;
    fault.found = "a path that " + why;
    fault.expected = "a scene file";
    LoadedScene loaded;
    loaded.faults.push_back(std::move(fault));
    return loaded;
}

// The scene only knows that an image is missing; this adds why.
void addReasons(std::vector<Fault>& faults,
                const std::map<std::string, ReadImages::Unread>& unread) {
    std::map<std::string, std::pair<std::string, std::string>> better;
    for (const auto& [name, file] : unread)
        better.try_emplace(imageFound(name, kUnreadImage), imageFound(name, "which " + file.why),
                           file.nearest);
    for (Fault& fault : faults) {
        const auto known = better.find(fault.found);
        if (known == better.end()) continue;
        fault.found = known->second.first;
        fault.expected += known->second.second;
    }
}

// What else the folder of a file that does not exist holds: a name that was probably meant, in
// words to put behind a message.
std::string nearestFile(const std::filesystem::path& missing) {
    constexpr std::size_t kMost = 4096;
    std::vector<std::string> names;
    std::error_code error;
    std::filesystem::directory_iterator files(missing.parent_path(), error);
    for (; !error && names.size() < kMost && files != std::filesystem::directory_iterator();
         files.increment(error))
        names.push_back(files->path().filename().string());
    std::sort(names.begin(), names.end());
    return suggestion(missing.filename().string(), {names.begin(), names.end()});
}

// Whether the name may be that of a shipped file, as shipped scenes name them.
bool isShippedFile(std::string_view name) {
    constexpr std::string_view kFolders[] = {"../textures/", "../see-through/", "../sheets/",
                                             "../sprites/"};
    return std::any_of(std::begin(kFolders), std::end(kFolders), [&](std::string_view folder) {
        return name.starts_with(folder) && name.find('/', folder.size()) == std::string::npos;
    });
}

}  // namespace

std::filesystem::path shippedFolder() {
    return SLICECAST_ASSETS;
}

std::string readPictureTable() {
    const ReadFile file = readWholeFile(shippedFolder() / "pictures.json", kMaxSceneBytes);
    return std::string(file.fault.empty() ? file.text() : kNoPictures);
}

ReadImages readImages(const ParsedScene& scene, const std::filesystem::path& folder) {
    ReadImages images;
    for (const std::string& name : scene.files) {
        const bool isShipped = name.starts_with(kShippedFile);
        const std::filesystem::path path =
            isShipped ? shippedFolder() / name.substr(kShippedFile.size()) : folder / pathOf(name);
        ReadFile file = readWholeFile(path, kMaxImageBytes);
        if (file.fault == kNoSuchFile && isShippedFile(name)) {
            ReadFile shipped =
                readWholeFile(shippedFolder() / "scenes" / pathOf(name), kMaxImageBytes);
            if (shipped.fault.empty()) file = std::move(shipped);
        }
        if (file.fault.empty()) {
            images.files.emplace(name, std::move(file.bytes));
        } else {
            images.unread.emplace(
                name, ReadImages::Unread{file.fault, file.fault == kNoSuchFile ? nearestFile(path)
                                                                               : std::string()});
        }
    }
    return images;
}

LoadedScene readSceneFile(const std::filesystem::path& scene, const Progress& progress) {
    const std::string name = scene.string();
    ReadFile text = readWholeFile(scene, kMaxSceneBytes);
    if (!text.fault.empty()) return notReadable(name, text.fault);
    ParsedScene parsed = parseScene(text.text(), name, progress, readPictureTable());
    text = {};
    const ReadImages images = readImages(parsed, scene.parent_path());
    LoadedScene loaded = loadScene(std::move(parsed), images.files, {}, progress);
    addReasons(loaded.faults, images.unread);
    return loaded;
}

}  // namespace slicecast
