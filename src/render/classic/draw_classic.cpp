#include "render/classic/draw_classic.h"

#include "base/sort.h"
#include "render/classic/colouring.h"
#include "render/classic/column_ray.h"
#include "render/classic/surfaces.h"
#include "render/classic/tile_spans.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace slicecast {
namespace {

using namespace classic;

// Written so that NaN is refused too.
bool canSee(const World& world, const Eye& eye, const RenderOptions& options) {
    return isAboveFloor(eye) && eye.map >= 0 && eye.map < static_cast<int>(world.maps.size()) &&
           options.fovDegrees >= kMinFovDegrees && options.fovDegrees <= kMaxFovDegrees &&
           eye.look >= -kMaxLook && eye.look <= kMaxLook &&
           eye.headingDegrees - eye.headingDegrees == 0.0;
}

bool canDrawInto(const Picture& picture) {
    return picture.pixels != nullptr && picture.width > 0 && picture.height > 0 &&
           picture.width <= kMaxPictureSide && picture.height <= kMaxPictureSide &&
           picture.pitch >= picture.width;
}

bool areInRange(const ClassicOptions& classic) {
    return classic.stepSize >= kLeastMarchStep && classic.stepSize <= kGreatestMarchStep &&
           classic.reach >= kLeastMarchReach && classic.reach <= kGreatestMarchReach &&
           classic.sineSteps >= 0 && classic.sineSteps <= kMostSineSteps &&
           classic.pixelSize >= 1 && classic.pixelSize <= kMostPixelSize;
}

// One column of the picture, `pixelSize` pixels wide.
class Column {
public:
    Column(const World& world, const View& view, const RenderOptions& options,
           const ClassicOptions& classicOptions, const Map& map, const RowGrid& rows,
           ClassicReport& report)
        : world_(world),
          map_(map),
          view_(view),
          options_(classicOptions),
          rows_(rows),
          colouring_(world, map, view, options),
          report_(report),
          colours_(static_cast<std::size_t>(rows.rows)) {}

    const std::vector<Pixel>& draw(double x) {
        ray_ = view_.rayAt(x);
        report_.samples += options_.march ? marchTiles(map_, view_, ray_, options_, spans_)
                                          : walkTiles(map_, view_, ray_, spans_);
        gatherSurfaces(world_, map_, view_, options_, ray_, rows_, spans_, surfaces_);
        if (options_.paintersOrder) {
            paintFarToNear();
        } else {
            paintNearest();
        }
        return colours_;
    }

private:
    // Every row shows the surface with the least depth there, laid over the next one where it is
    // see-through.
    void paintNearest() {
        for (int row = 0; row < rows_.rows; ++row) {
            const double y = rows_.middle(row);
            layers_.clear();
            Place at;
            do {
                at = nextBehind(at, row);
                layers_.push_back(at.surface != nullptr ? colouring_.ofSurface(*at.surface, ray_, y)
                                                        : colouring_.ofBackground(ray_, y));
            } while (at.surface != nullptr && toColour(layers_.back()).a < 255);
            Pixel colour = layers_.back();
            for (std::size_t i = layers_.size() - 1; i-- > 0;)
                colour = laidOver(layers_[i], colour);
            paint(row, colour);
        }
    }

    // Where a ray meets a surface; nothing is before the first one. At equal depth the order is
    // that of Passing, then that of the gathering.
    struct Place {
        const Surface* surface = nullptr;
        double depth = 0.0;

        bool isBefore(const Place& other) const {
            if (depth != other.depth) return depth < other.depth;
            if (surface->passing != other.surface->passing)
                return surface->passing < other.surface->passing;
            return surface < other.surface;
        }
    };

    Place nextBehind(const Place& last, int row) const {
        Place next;
        for (const Surface& surface : surfaces_) {
            if (row < surface.firstRow || row >= surface.lastRow) continue;
            const Place place = {&surface, surface.depthAt(view_, ray_, rows_.middle(row))};
            const bool isBehind = last.surface == nullptr || last.isBefore(place);
            if (isBehind && (next.surface == nullptr || place.isBefore(next))) next = place;
        }
        return next;
    }

    // Everything is painted, whole blocks by the distances of their middles; who comes later wins.
    // No depths are compared.
    void paintFarToNear() {
        for (int row = 0; row < rows_.rows; ++row)
            paint(row, colouring_.ofBackground(ray_, rows_.middle(row)));
        order_.resize(surfaces_.size());
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        mergeSort(order_, [this](std::size_t a, std::size_t b) {
            const double distanceA = surfaces_[a].thingDistance;
            const double distanceB = surfaces_[b].thingDistance;
            return distanceA != distanceB ? distanceA > distanceB : a < b;
        });
        for (const std::size_t index : order_) {
            const Surface& surface = surfaces_[index];
            for (int row = surface.firstRow; row < surface.lastRow; ++row) {
                paint(row, laidOver(colouring_.ofSurface(surface, ray_, rows_.middle(row)),
                                    colours_[static_cast<std::size_t>(row)]));
            }
        }
    }

    void paint(int row, Pixel colour) {
        colours_[static_cast<std::size_t>(row)] = colour;
        ++report_.pixelsPainted;
    }

    const World& world_;
    const Map& map_;
    const View& view_;
    const ClassicOptions& options_;
    const RowGrid& rows_;
    Colouring colouring_;
    ClassicReport& report_;
    ColumnRay ray_;
    std::vector<TileSpan> spans_;
    std::vector<Surface> surfaces_;
    std::vector<std::size_t> order_;
    std::vector<Pixel> layers_;
    std::vector<Pixel> colours_;
};

}  // namespace

bool drawClassic(const World& world, const Eye& eye, const RenderOptions& options,
                 const ClassicOptions& classic, const Picture& picture, ClassicReport* report) {
    if (!canSee(world, eye, options) || !canDrawInto(picture) || !areInRange(classic)) return false;
    ClassicReport counted;
    const int size = classic.pixelSize;
    const Map& map = world.maps[static_cast<std::size_t>(eye.map)];
    const View view(eye, map.levels, options, classic, picture.width, picture.height);
    const RowGrid rows = {size, (picture.height + size - 1) / size};
    Column column(world, view, options, classic, map, rows, counted);
    for (int left = 0; left < picture.width; left += size) {
        const std::vector<Pixel>& colours = column.draw(left + size / 2.0);
        const int right = std::min(left + size, picture.width);
        for (int y = 0; y < picture.height; ++y)
            std::fill(picture.row(y) + left, picture.row(y) + right,
                      colours[static_cast<std::size_t>(y / size)]);
    }
    if (report != nullptr) *report = counted;
    return true;
}

}  // namespace slicecast
