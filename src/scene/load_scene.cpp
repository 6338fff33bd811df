#include "base/sort.h"
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

// Reads the images of one scene, and collects what is wrong with them.
class ImageReader {
public:
    ImageReader(const SceneDescription& description, const SceneFiles& files, EarlyImages& early)
        : description_(description), files_(files), early_(early) {}

    // A picture that has been made already is copied.
    Texture texture(const TextureReference& texture, std::string name,
                    const std::vector<Texture>& made) {
        const ImageReference& reference = texture.image;
        const auto next = static_cast<std::size_t>(&texture - description_.textures.data());
        const auto [known, isNew] = textures_.emplace(keyOf(texture), next);
        if (!isNew && !made[known->second].levels.empty()) {
            const Texture& like = made[known->second];
            if (!take(reference,
                      like.levels[0].texels.size() * static_cast<std::size_t>(like.frames())))
                return {};
            Texture copy = like;
            copy.name = std::move(name);
            copy.rate = like.frames() > 1 ? texture.rate : 0.0;
            return copy;
        }
        const Image image =
            texture.colour ? plain(*texture.colour)
                           : decode(reference, kMaxTextureSize * texture.frames, kMaxTextureSize);
        if (image.empty()) return {};
        const bool fits = image.width == image.height * texture.frames;
        const bool isPowerOfTwo = std::has_single_bit(static_cast<unsigned>(image.height));
        if (!fits || !isPowerOfTwo || image.height < kMinTextureSize) {
            const char* const sizes = "8, 16, 32, 64, 128, 256, 512 or 1024 pixels a side";
            add(reference, {"which is ", image.width, "x", image.height, " pixels"},
                texture.frames == 1 ? words("a square texture of ", sizes)
                                    : words("a sheet of ", texture.frames,
                                            " square frames side by side, each of ", sizes));
            return {};
        }
        return take(reference, image.pixels.size())
                   ? makeTexture(std::move(name), image, texture.frames, texture.rate)
                   : Texture{};
    }

    Sprite sprite(const TextureReference& sprite, std::string name,
                  const std::vector<Sprite>& made) {
        const ImageReference& reference = sprite.image;
        const auto next = static_cast<std::size_t>(&sprite - description_.sprites.data());
        const auto [known, isNew] = sprites_.emplace(keyOf(sprite), next);
        if (!isNew && !made[known->second].frames.empty()) {
            const Sprite& like = made[known->second];
            if (!take(reference, like.frames.size() * like.frames[0][0].texels.size())) return {};
            Sprite copy = like;
            copy.name = std::move(name);
            copy.rate = sprite.frames > 1 ? sprite.rate : 0.0;
            return copy;
        }
        const Image image =
            decode(reference, kMaxSpriteSide * sprite.frames, kMaxSpriteSide * sprite.views);
        if (image.empty()) return {};
        if (image.width % sprite.frames != 0) {
            add(reference, {"which is ", image.width, "x", image.height, " pixels"},
                {"a sheet of ", sprite.frames, " frames of equal width side by side"});
            return {};
        }
        if (image.height % sprite.views != 0) {
            add(reference, {"which is ", image.width, "x", image.height, " pixels"},
                {"a sheet of ", sprite.views, " rows of equal height"});
            return {};
        }
        return take(reference, image.pixels.size())
                   ? makeSprite(std::move(name), image, sprite.frames, sprite.rate, sprite.views)
                   : Sprite{};
    }

    // A file that several maps show is decoded once.
    Image panorama(const PanoramaReference& panorama, const std::vector<Map>& maps) {
        const ImageReference& reference = panorama.image;
        const auto known = panoramas_.find(reference.file);
        if (known != panoramas_.end()) {
            const Image& image = maps[known->second].sky.panorama;
            return take(reference, image.pixels.size()) ? image : Image{};
        }
        Image image = decode(reference, kMaxPanoramaWidth, kMaxPanoramaHeight);
        if (image.empty() || !isOpaque(reference, image) || !take(reference, image.pixels.size()))
            return {};
        panoramas_.emplace(reference.file, panorama.map);
        return image;
    }

    // In the order of the text.
    std::vector<Fault> takeFaults() {
        mergeSort(faults_, [](const Fault& a, const Fault& b) {
            return std::tie(a.line, a.column, a.pointer, a.found) <
                   std::tie(b.line, b.column, b.pointer, b.found);
        });
        if (faults_.size() > kMaxFaults) {
            const std::size_t omitted = faults_.size() - kMaxFaults;
            faults_.resize(kMaxFaults);
            faults_.push_back(moreFaults(description_.fileName, omitted));
        }
        return std::move(faults_);
    }

private:
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
    const SceneFiles& files_;
    EarlyImages& early_;
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

LoadedScene loadScene(ParsedScene scene, const SceneFiles& files, EarlyImages early) {
    LoadedScene loaded;
    if (!scene.description) {
        loaded.faults = std::move(scene.faults);
        return loaded;
    }
    SceneDescription& description = *scene.description;
    ImageReader reader(description, files, early);
    World world = std::move(description.world);
    for (std::size_t i = 0; i < world.textures.size(); ++i) {
        world.textures[i] = reader.texture(description.textures[i],
                                           std::move(world.textures[i].name), world.textures);
        world.textures[i].material = description.textures[i].material;
    }
    for (std::size_t i = 0; i < world.sprites.size(); ++i)
        world.sprites[i] =
            reader.sprite(description.sprites[i], std::move(world.sprites[i].name), world.sprites);
    for (const PanoramaReference& panorama : description.panoramas) {
        world.maps[panorama.map].sky.panorama = reader.panorama(panorama, world.maps);
    }
    loaded.faults = reader.takeFaults();
    if (loaded.faults.empty()) {
        makeGateFrames(world);
        markSeeThrough(world);
        markPlans(world);
        for (Map& map : world.maps) widenObjects(world, map);
        startObjects(world);
        startQuest(world);
    }
    if (loaded.faults.empty()) {
        loaded.warnings = std::move(scene.warnings);
        for (HiddenThing& thing : description.hiddenThings) {
            if (!world.blueprints[thing.block].seeThrough)
                loaded.warnings.push_back(std::move(thing.warning));
        }
        loaded.aims = std::move(description.aims);
        loaded.world = std::move(world);
    }
    return loaded;
}

}  // namespace slicecast
