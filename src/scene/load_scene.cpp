#include "base/later_text.h"
#include "base/sort.h"
#include "base/task_list.h"
#include "base/words.h"
#include "scene/checker.h"
#include "scene/description.h"
#include "scene/limits.h"
#include "scene/scene.h"

#include <algorithm>
#include <bit>
#include <map>
#include <tuple>
#include <utility>

namespace slicecast {
namespace {

// Reads the images of one scene, and collects what is wrong with them. Each frame is a task.
class ImageReader {
public:
    ImageReader(const SceneDescription& description, World& world, const SceneFiles& files,
                EarlyImages early, TaskList& tasks)
        : description_(description),
          world_(world),
          files_(files),
          early_(std::move(early)),
          tasks_(tasks) {}

    // A picture that has been made already is shared.
    void readTexture(std::size_t index) {
        const TextureReference& wanted = description_.textures[index];
        const ImageReference& reference = wanted.image;
        Texture& texture = world_.textures[index];
        texture.material = wanted.material;
        texture.rate = wanted.frames > 1 ? wanted.rate : 0.0;
        const auto [known, isNew] = textures_.emplace(keyOf(wanted), index);
        const Texture& like = world_.textures[known->second];
        if (!isNew && !like.levels.empty()) {
            texture.levels = like.levels;
            texture.laterFrames = like.laterFrames;
            texture.seeThrough = like.seeThrough;
            return;
        }
        sheet_ = wanted.colour
                     ? plain(*wanted.colour)
                     : decode(reference, kMaxTextureSize * wanted.frames, kMaxTextureSize);
        if (sheet_.empty()) return;
        const bool fits = sheet_.width == sheet_.height * wanted.frames;
        const bool isPowerOfTwo = std::has_single_bit(static_cast<unsigned>(sheet_.height));
        if (!fits || !isPowerOfTwo || sheet_.height < kMinTextureSize) {
            refuseSize(reference, wanted.frames);
            return;
        }
        if (!take(reference, sheet_.pixels.size())) return;
        texture.seeThrough = !sheet_.isOpaque();
        current_ = index;
        for (int frame = 0; frame < wanted.frames; ++frame)
            tasks_.add<&ImageReader::makeTextureFrame>(*this, static_cast<std::size_t>(frame));
    }

    void readSprite(std::size_t index) {
        const TextureReference& wanted = description_.sprites[index];
        const ImageReference& reference = wanted.image;
        Sprite& sprite = world_.sprites[index];
        sprite.views = wanted.views;
        sprite.rate = wanted.frames > 1 ? wanted.rate : 0.0;
        const auto [known, isNew] = sprites_.emplace(keyOf(wanted), index);
        const Sprite& like = world_.sprites[known->second];
        if (!isNew && !like.frames.empty()) {
            sprite.frames = like.frames;
            return;
        }
        sheet_ = decode(reference, kMaxSpriteSide * wanted.frames, kMaxSpriteSide * wanted.views);
        if (sheet_.empty()) return;
        if (sheet_.width % wanted.frames != 0) {
            add(reference, {"which is ", sheet_.width, "x", sheet_.height, " pixels"},
                {"a sheet of ", wanted.frames, " frames of equal width side by side"});
            return;
        }
        if (sheet_.height % wanted.views != 0) {
            add(reference, {"which is ", sheet_.width, "x", sheet_.height, " pixels"},
                {"a sheet of ", wanted.views, " rows of equal height"});
            return;
        }
        if (!take(reference, sheet_.pixels.size())) return;
        current_ = index;
        for (int frame = 0; frame < wanted.frames * wanted.views; ++frame)
            tasks_.add<&ImageReader::makeSpriteFrame>(*this, static_cast<std::size_t>(frame));
    }

    // A file that several maps show is decoded once.
    void readPanorama(std::size_t index) {
        const PanoramaReference& wanted = description_.panoramas[index];
        const ImageReference& reference = wanted.image;
        Image& panorama = world_.maps[wanted.map].sky.panorama;
        const auto known = panoramas_.find(reference.file);
        if (known != panoramas_.end()) {
            const Image& like = world_.maps[known->second].sky.panorama;
            if (take(reference, like.pixels.size())) panorama = like;
            return;
        }
        Image image = decode(reference, kMaxPanoramaWidth, kMaxPanoramaHeight);
        if (image.empty() || !isOpaque(reference, image) || !take(reference, image.pixels.size()))
            return;
        panoramas_.emplace(reference.file, wanted.map);
        panorama = std::move(image);
    }

    // With those of the text, in its order.
    std::vector<Fault> takeFaults(std::vector<Fault> ofText) {
        mergeSort(faults_, [](const Fault& a, const Fault& b) {
            return std::tie(a.line, a.column, a.pointer, a.found) <
                   std::tie(b.line, b.column, b.pointer, b.found);
        });
        if (!ofText.empty()) addFaults(std::move(ofText));
        if (faults_.size() > kMaxFaults) {
            const std::size_t omitted = faults_.size() - kMaxFaults;
            faults_.resize(kMaxFaults);
            faults_.push_back(moreFaults(description_.fileName, omitted));
        }
        return std::move(faults_);
    }

private:
    // Not copied to where it is called: few scenes need it before their picture.
    __attribute__((noinline)) void addFaults(std::vector<Fault> ofText) {
        for (Fault& fault : faults_) ofText.push_back(std::move(fault));
        mergeSort(ofText, [](const Fault& a, const Fault& b) {
            return a.line != b.line ? a.line < b.line : a.column < b.column;
        });
        faults_ = std::move(ofText);
    }

    // Of a texture.
    __attribute__((noinline)) void refuseSize(const ImageReference& reference, int frames) {
        const char* const sizes = "8, 16, 32, 64, 128, 256, 512 or 1024 pixels a side"_later;
        const int squares = sheet_.width / sheet_.height;
        const bool isSheet = frames == 1 && squares >= 2 && sheet_.width == squares * sheet_.height;
        const std::string expected =
            frames == 1 ? words("a square texture of "_later, sizes)
                        : words("a sheet of ", frames,
                                " square frames side by side, each of "_later, sizes);
        add(reference, {"which is ", sheet_.width, "x", sheet_.height, " pixels"},
            isSheet ? words(expected, "; a sheet of frames says \"frames\": "_later, squares)
                    : expected);
    }

    void makeTextureFrame(std::size_t frame) {
        Texture& texture = world_.textures[current_];
        std::vector<TextureLevel> levels =
            textureFrame(sheet_, static_cast<int>(frame), texture.seeThrough);
        if (frame == 0)
            texture.levels = std::move(levels);
        else
            texture.laterFrames.push_back(std::move(levels));
    }

    void makeSpriteFrame(std::size_t frame) {
        const TextureReference& wanted = description_.sprites[current_];
        world_.sprites[current_].frames.push_back(
            spriteFrame(sheet_, static_cast<int>(frame), wanted.frames, wanted.views));
    }

    void add(const ImageReference& reference, const Words& found, const Words& expected) {
        Fault fault;
        fault.file = description_.fileName;
        fault.pointer = reference.pointer;
        fault.line = reference.place.line;
        fault.column = reference.place.column;
        fault.found = imageFound(reference.file, found.str());
        fault.expected = expected.str();
        faults_.push_back(std::move(fault));
    }

    Image decode(const ImageReference& reference, int maxWidth, int maxHeight) {
        if (reference.file.empty()) return {};  // the text's fault
        const auto file = files_.find(reference.file);
        if (file == files_.end()) {
            add(reference, kUnreadImage, "a PNG file of that name, relative to the scene's folder");
            return {};
        }
        Image early = early_.take(reference.file);
        if (!early.empty() && early.width <= maxWidth && early.height <= maxHeight) return early;
        DecodedImage decoded = decodePng(file->second, maxWidth, maxHeight);
        if (!decoded.fault.empty()) {
            add(reference, {"which ", decoded.fault},
                {"a PNG file of at most ", maxWidth, "x", maxHeight, " pixels"});
        }
        return std::move(decoded.image);
    }

    // All of one colour. Each texel has one light, so few texels would show as steps.
    static Image plain(Colour colour) {
        constexpr int kSide = 64;
        Image image(kSide, kSide);
        std::fill(image.pixels.begin(), image.pixels.end(), toPixel(colour));
        return image;
    }

    // What tells pictures apart that are made of files: rates do not.
    static std::string keyOf(const TextureReference& picture) {
        return words(picture.image.file, "\n", picture.frames, " ", picture.views);
    }

    // Counts the image's memory. False if all images together take too much.
    bool take(const ImageReference& reference, std::size_t texels) {
        texels_ += static_cast<std::int64_t>(texels);
        if (texels_ <= kMaxSceneTexels) return true;
        add(reference, {"which brings the scene's images to ", texels_, " pixels"},
            {"at most ", kMaxSceneTexels});
        texels_ -= static_cast<std::int64_t>(texels);
        return false;
    }

    // Nothing lies behind the sky.
    bool isOpaque(const ImageReference& reference, const Image& image) {
        if (image.isOpaque()) return true;
        const auto seeThrough = std::find_if(image.pixels.begin(), image.pixels.end(),
                                             [](Pixel pixel) { return toColour(pixel).a != 255; });
        const auto index = seeThrough - image.pixels.begin();
        add(reference,
            {"which has a see-through pixel at column ", index % image.width, ", row ",
             index / image.width},
            "an opaque picture, because nothing lies behind the sky");
        return false;
    }

    const SceneDescription& description_;
    World& world_;
    const SceneFiles& files_;
    EarlyImages early_;
    TaskList& tasks_;
    Image sheet_;              // whose frames are being made
    std::size_t current_ = 0;  // the texture or sprite that shows it
    std::vector<Fault> faults_;
    std::map<std::string, std::size_t> textures_;   // the first texture of a picture
    std::map<std::string, std::size_t> sprites_;    // the first sprite of a picture
    std::map<std::string, std::size_t> panoramas_;  // the first map that shows the file
    std::int64_t texels_ = 0;
};

// An object without a width gets one from its height and its sprite's shape.
void widenObjects(const World& world, Map& map) {
    for (Object& object : map.objects) {
        if (object.width > Coordinate{0}) continue;
        const SpriteLevel& shape = world.sprites[object.sprite].frames[0][0];
        object.width = std::max(Coordinate{1},
                                toCoordinate(object.height.value() * shape.width / shape.height));
    }
}

}  // namespace

std::span<Pixel> EarlyImages::decode(const std::string& name, std::span<const std::uint8_t> bytes,
                                     bool blank) {
    // Faults are reported later, when it is known what the image is for.
    if (texels_ + pixelsOfPng(bytes) > kMaxSceneTexels) return {};
    Image image = decodePng(bytes, kMaxPanoramaWidth, kMaxPanoramaHeight, blank).image;
    texels_ += static_cast<std::int64_t>(image.pixels.size());
    return (images_[name] = std::move(image)).pixels;
}

Image EarlyImages::take(const std::string& name) {
    const auto found = images_.find(name);
    return found != images_.end() ? std::exchange(found->second, {}) : Image{};
}

std::string imageFound(std::string_view name, std::string_view what) {
    return words("\"", name, "\", ", what);
}

struct SceneLoader::Work {
    Work(ParsedScene given, const SceneFiles& files, EarlyImages early)
        : scene(std::move(given)),
          reader(*scene.description, world, files, std::move(early), tasks) {
        world = std::move(scene.description->world);
        for (std::size_t i = 0; i < world.textures.size(); ++i)
            tasks.add<&ImageReader::readTexture>(reader, i);
        for (std::size_t i = 0; i < world.sprites.size(); ++i)
            tasks.add<&ImageReader::readSprite>(reader, i);
        for (std::size_t i = 0; i < scene.description->panoramas.size(); ++i)
            tasks.add<&ImageReader::readPanorama>(reader, i);
        tasks.add<&Work::prepare>(*this);
    }

    // Once all pictures are there.
    void prepare();
    void widenAllObjects();
    void finish();

    ParsedScene scene;
    World world;
    TaskList tasks;
    ImageReader reader;
    LoadedScene loaded;
};

void SceneLoader::Work::prepare() {
    // Of too many, the last one counts the others.
    loaded.faults = scene.faults.size() > kMaxFaults ? std::move(scene.faults)
                                                     : reader.takeFaults(std::move(scene.faults));
    if (!loaded.faults.empty()) return;
    tasks.add<makeGateFrames>(world);
    tasks.add<markSeeThrough>(world);
    tasks.add<markPlans>(world);
    tasks.add<&Work::widenAllObjects>(*this);
    tasks.add<startObjects>(world);
    tasks.add<&Work::finish>(*this);
}

void SceneLoader::Work::widenAllObjects() {
    for (Map& map : world.maps) widenObjects(world, map);
}

void SceneLoader::Work::finish() {
    startQuest(world);
    loaded.warnings = std::move(scene.warnings);
    for (HiddenThing& thing : scene.description->hiddenThings) {
        if (!world.blueprints[thing.block].seeThrough)
            loaded.warnings.push_back(std::move(thing.warning));
    }
    loaded.aims = std::move(scene.description->aims);
    loaded.world = std::move(world);
}

SceneLoader::SceneLoader(ParsedScene scene, const SceneFiles& files, EarlyImages early) {
    if (scene.description == nullptr)
        faults_ = std::move(scene.faults);
    else
        work_ = std::make_unique<Work>(std::move(scene), files, std::move(early));
}
SceneLoader::SceneLoader(SceneLoader&&) noexcept = default;
SceneLoader& SceneLoader::operator=(SceneLoader&&) noexcept = default;
SceneLoader::~SceneLoader() = default;

bool SceneLoader::next() {
    return work_ != nullptr && work_->tasks.doNext();
}

double SceneLoader::share() const {
    return work_ != nullptr ? work_->tasks.share() : 1.0;
}

LoadedScene SceneLoader::take() {
    if (work_ != nullptr) return std::move(work_->loaded);
    LoadedScene loaded;
    loaded.faults = std::move(faults_);
    return loaded;
}

std::unique_ptr<LoadedScene> SceneLoader::nextOrTake() {
    if (work_ == nullptr) return std::make_unique<LoadedScene>();
    if (work_->tasks.doNext()) return nullptr;
    return std::make_unique<LoadedScene>(std::move(work_->loaded));
}

LoadedScene loadScene(ParsedScene scene, const SceneFiles& files, EarlyImages early,
                      const Progress& progress) {
    SceneLoader loader(std::move(scene), files, std::move(early));
    while (loader.next()) {
        if (progress) progress(kShareOfParsing + (1.0 - kShareOfParsing) * loader.share());
    }
    return loader.take();
}

}  // namespace slicecast
