#include "cutout.h"

#include <algorithm>
#include <array>

namespace slicecast::textures {

namespace {

// The sum of some texels, each counted by its weight.
struct Mixture {
    int r = 0;
    int g = 0;
    int b = 0;
    int weight = 0;

    void add(const Colour& colour, int share) {
        r += colour.r * share;
        g += colour.g * share;
        b += colour.b * share;
        weight += share;
    }

    Colour colour(std::uint8_t alpha) const {
        const auto mean = [this](int sum) {
            return static_cast<std::uint8_t>((sum + weight / 2) / weight);
        };
        return {mean(r), mean(g), mean(b), alpha};
    }
};

bool lies(const Picture& picture, int x, int y) {
    return x >= 0 && x < picture.width && y >= 0 && y < picture.height;
}

}  // namespace

Picture holesFilled(Picture picture, Border border) {
    constexpr int kRounds = 4;  // as far as the first levels of detail reach over an edge
    Mixture whole;
    for (const Colour& colour : picture.pixels) {
        whole.add(colour, colour.a > 0 ? 1 : 0);
    }
    std::vector<char> known(picture.pixels.size());
    std::transform(picture.pixels.begin(), picture.pixels.end(), known.begin(),
                   [](const Colour& colour) { return colour.a > 0 ? 1 : 0; });
    for (int round = 0; round <= kRounds; ++round) {
        const Picture before = picture;
        const std::vector<char> knownBefore = known;
        for (int y = 0; y < picture.height; ++y) {
            for (int x = 0; x < picture.width; ++x) {
                const auto index =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                    static_cast<std::size_t>(x);
                if (knownBefore[index] != 0) {
                    continue;
                }
                Mixture near;
                for (int dy = -1; dy <= 1; ++dy) {
                    for (int dx = -1; dx <= 1; ++dx) {
                        const int fromX = wrap(x + dx, picture.width);
                        const int fromY = wrap(y + dy, picture.height);
                        const auto from = static_cast<std::size_t>(fromY) *
                                              static_cast<std::size_t>(picture.width) +
                                          static_cast<std::size_t>(fromX);
                        if (knownBefore[from] != 0 &&
                            (border == Border::Repeats || lies(picture, x + dx, y + dy))) {
                            near.add(before.at(fromX, fromY), 1);
                        }
                    }
                }
                if (round == kRounds) {
                    picture.at(x, y) = whole.colour(0);
                } else if (near.weight > 0) {
                    picture.at(x, y) = near.colour(0);
                    known[index] = 1;
                }
            }
        }
    }
    return picture;
}

Picture edgesSoftened(const Picture& picture) {
    static constexpr std::array<int, 3> kShares = {1, 2, 1};
    Picture soft = picture;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            Mixture near;
            int alphas = 0;
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx) {
                    const int fromY = std::min(y + dy, picture.height - 1);
                    if (!lies(picture, x + dx, fromY)) {
                        continue;
                    }
                    const Colour& colour = picture.at(x + dx, fromY);
                    const int share = kShares[static_cast<std::size_t>(dx + 1)] *
                                      kShares[static_cast<std::size_t>(dy + 1)];
                    near.add(colour, colour.a > 0 ? share : 0);
                    alphas += share * colour.a;
                }
            }
            // Steeper than the mean of the neighbours, so that thin things stay strong
            const int alpha = std::clamp((alphas * 7 / 4) / 16 - 64, 0, 255);
            Colour& own = soft.at(x, y);
            if (own.a == 0 && alpha > 0) {
                own = near.colour(static_cast<std::uint8_t>(alpha));
            } else if (own.a > 0) {
                own.a = static_cast<std::uint8_t>(std::max(std::min<int>(own.a, alpha), own.a / 2));
            }
        }
    }
    return soft;
}

Picture paintNothing() {
    Picture picture(kSide, kSide);
    std::fill(picture.pixels.begin(), picture.pixels.end(),
              Colour{kSlate3.r, kSlate3.g, kSlate3.b, 0});
    return picture;
}

Picture inARow(const std::vector<Picture>& frames) {
    const int width = frames.front().width;
    Picture row(width * static_cast<int>(frames.size()), frames.front().height);
    for (int y = 0; y < row.height; ++y) {
        for (int x = 0; x < row.width; ++x) {
            row.at(x, y) = frames[static_cast<std::size_t>(x / width)].at(x % width, y);
        }
    }
    return row;
}

}  // namespace slicecast::textures
