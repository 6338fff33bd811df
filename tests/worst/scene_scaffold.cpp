#include "scene_scaffold.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <vector>

namespace slicecast {

namespace {

class SceneText {
public:
    SceneText(const Genes& genes, const ScenePictures& pictures, int widest)
        : genes_(genes), pictures_(pictures), widest_(widest), random_(genes[Gene::seed] + 1u) {}

    std::string text() {
        side_ = 8 + genes_[Gene::size] * (widest_ - 8) / 255;
        constexpr int kMostCells = 80'000;  // a character each: there is room for more
        levels_ = std::min(1 + genes_[Gene::levels] / 8, std::max(1, kMostCells / (side_ * side_)));
        fill();
        const int strength = (genes_[Gene::mirrors] >> 4) + 1;
        mirror_ = ", \"mirror\": " + number(strength / 16.0);
        const bool hasRoofs = (genes_[Gene::mirrors] & 2) != 0;
        std::string text = "{\"title\": \"worst\",\n\"textures\": {\"stone\": \"" + pictures_.wall +
                           "\", \"glass\": \"" + pictures_.seeThrough +
                           "\",\n  \"door\": " + sheet(pictures_.sheet, pictures_.sheetFrames) +
                           "},\n\"sprites\": {\"bush\": \"" + pictures_.sprite +
                           "\",\n  \"walker\": " + sheet(pictures_.walker, pictures_.walkerFrames) +
                           "},\n";
        text += R"("motions": {"lift": {"moves": "both", "from": 0, "to": 0.5, "period": 3}},
"blueprints": {"wall": {"faces": {"all": "stone"})";
        if (hasRoofs)
            text.replace(text.rfind("\"all\""), std::string::npos,
                         "\"all\": \"stone\", \"top\": {\"texture\": \"stone\"" + mirror_ + "}}");
        text += R"(}, "pane": {"faces": "glass", "join": false},
  "gate": {"faces": "door", "gate": {"approach": 2}},
  "lift": {"top": 0.5, "faces": "stone", "motion": "lift"},
  "pond": {"top": 0.75, "water": true, "faces": {"top": "glass"}}},
"legend": {"#": "wall", "g": "pane", "G": "gate", "l": "lift", "w": "pond"},
"maps": [{"name": "map", "levels": [)";
        for (int level = 0; level < levels_; ++level) {
            text += level == 0 ? "[" : ",\n[";
            for (int y = 0; y < side_; ++y) {
                text += y == 0 ? "\"" : "\", \"";
                text += rows_[static_cast<std::size_t>(level * side_ + y)];
            }
            text += "\"]";
        }
        text += "],\n\"floor\": {\"texture\": \"stone\"";
        if ((genes_[Gene::mirrors] & 1) != 0) text += mirror_;
        text += "}";
        if (genes_[Gene::ceiling] >= 64) {
            text += ", \"ceiling\": {\"texture\": \"stone\", \"height\": " +
                    number(genes_[Gene::ceiling] / 8.0);
            if ((genes_[Gene::mirrors] & 4) != 0) text += mirror_;
            text += "}";
        }
        addSowing(text);
        addPortals(text);
        const int middle = side_ / 2;
        if (genes_[Gene::walkers] > 0) addPatrol(text, middle);
        const double height = std::min<double>(genes_[Gene::eye] / 16.0, levels_);
        text += "}]";
        if (hasPortals_)
            text += ",\n\"portalLimit\": " + std::to_string(1 + genes_[Gene::limit] / 8);
        text += ",\n\"start\": {\"x\": " + number(middle + 0.5) +
                ", \"y\": " + number(middle + 0.5) + ", \"z\": " + number(height) +
                ", \"heading\": 20}}\n";
        return text;
    }

private:
    static std::string sheet(const std::string& file, int frames) {
        return "{\"file\": \"" + file + "\", \"frames\": " + std::to_string(frames) + "}";
    }

    static std::string number(double value) {
        std::array<char, 32> digits;
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
        return {digits.data(), end};
    }

    bool isChosen(Gene gene) {
        const auto share = static_cast<std::uint64_t>(genes_[gene]);
        return share > 0 && random_.next() % 256 < share;
    }
    int pick(int count) {
        return static_cast<int>(random_.next() % static_cast<std::uint64_t>(count));
    }

    // Around the eye it stays free, so that there is something to see.
    void fill() {
        rows_.assign(static_cast<std::size_t>(levels_ * side_),
                     std::string(static_cast<std::size_t>(side_), '.'));
        const int wellHeight = std::min(levels_, genes_[Gene::well] / 8);
        const int middle = side_ / 2;
        for (int level = 0; level < levels_; ++level) {
            for (int y = 0; y < side_; ++y) {
                for (int x = 0; x < side_; ++x) {
                    char& cell = at(x, y, level);
                    const int away = std::max(std::abs(x - middle), std::abs(y - middle));
                    if (level < wellHeight && away == 3) {
                        cell = '#';
                        sites_.push_back({x, y, level});
                        continue;
                    }
                    if (away <= 2) continue;
                    if (isChosen(Gene::walls)) {
                        cell = '#';
                        sites_.push_back({x, y, level});
                    } else if (isChosen(Gene::glass)) {
                        cell = 'g';
                    } else if (isChosen(Gene::gates)) {
                        cell = 'G';
                    } else if (isChosen(Gene::movers)) {
                        cell = 'l';
                    } else if (isChosen(Gene::water)) {
                        cell = 'w';
                    }
                }
            }
        }
        // Those beside the eye come first, whatever else there is.
        const auto distance = [&](const Site& site) {
            return std::abs(site.x - middle) + std::abs(site.y - middle);
        };
        std::stable_sort(sites_.begin(), sites_.end(),
                         [&](const Site& a, const Site& b) { return distance(a) < distance(b); });
    }
    char& at(int x, int y, int level) {
        return rows_[static_cast<std::size_t>(level * side_ + y)][static_cast<std::size_t>(x)];
    }

    // The limit on objects is of those that would stand there: the densities keep below it.
    void addSowing(std::string& text) {
        const double tiles = side_ * side_;
        const double bushes = std::min(genes_[Gene::bushes] / 256.0, 60'000 / tiles);
        const double walkers = std::min(genes_[Gene::walkers] / 256.0, 3'800 / tiles);
        std::string sown;
        if (bushes > 0)
            sown += R"({"sprite": "bush", "density": )" + number(bushes) +
                    R"(, "seed": 4, "height": [0.2, 0.6]})";
        if (walkers > 0)
            sown += std::string(sown.empty() ? "" : ", ") + R"({"sprite": "walker", "density": )" +
                    number(walkers) +
                    R"(, "height": 0.5, "motion": {"kind": "wander", "speed": 1}})";
        if (!sown.empty()) text += ",\n\"sow\": [" + sown + "]";
    }

    // Keys of a path are met only where there is one.
    void addPatrol(std::string& text, int middle) {
        const std::string y = number(middle + 0.5);
        const auto point = [&](double x) { return "\"x\": " + number(x) + ", \"y\": " + y; };
        text += ",\n\"objects\": [{\"sprite\": \"walker\", \"height\": 0.5, " +
                point(middle + 0.5) + R"(, "motion": {"kind": "patrol", "speed": 1, "path": [{)" +
                point(middle + 1.5) + "}, {" + point(middle - 0.5) + "}]}}]";
    }

    void addPortals(std::string& text) {
        const int wanted = genes_[Gene::portals] * 4;
        std::string made;
        int count = 0;
        for (const Site& site : sites_) {
            if (count >= wanted) break;
            const int middle = side_ / 2;
            // The side that looks at the eye.
            const int dx = site.x - middle;
            const int dy = site.y - middle;
            const bool isAlongX = std::abs(dx) >= std::abs(dy);
            const char* const face =
                isAlongX ? (dx > 0 ? "west" : "east") : (dy > 0 ? "north" : "south");
            const int reach = 4 + genes_[Gene::far] * (side_ - 8) / 512;
            const int x = std::clamp(middle + pick(2 * reach + 1) - reach, 0, side_ - 1);
            const int y = std::clamp(middle + pick(2 * reach + 1) - reach, 0, side_ - 1);
            if (at(x, y, site.level) != '.') continue;
            made += std::string(count == 0 ? "" : ",\n") + "{\"x\": " + std::to_string(site.x) +
                    ", \"y\": " + std::to_string(site.y) +
                    ", \"level\": " + std::to_string(site.level) + ", \"face\": \"" + face +
                    "\", \"to\": {\"x\": " + std::to_string(x) + ", \"y\": " + std::to_string(y) +
                    ", \"level\": " + std::to_string(site.level) +
                    "}, \"turn\": " + std::to_string(90 * pick(4)) + "}";
            ++count;
        }
        if (count > 0) text += ",\n\"portals\": [" + made + "]";
        hasPortals_ = count > 0;
    }

    struct Site {
        int x, y, level;
    };

    const Genes& genes_;
    const ScenePictures& pictures_;
    int widest_;
    Random random_;
    int side_ = 0;
    int levels_ = 0;
    bool hasPortals_ = false;
    std::string mirror_;
    std::vector<std::string> rows_;  // level after level, south after north
    std::vector<Site> sites_;        // walls, where portals can be
};

}  // namespace

std::string sceneScaffold(const Genes& genes, const ScenePictures& pictures, int widest) {
    return SceneText(genes, pictures, widest).text();
}

}  // namespace slicecast
