// Lists the blocks that one column of a picture meets, from near to far.
//
//     example-hits assets/scenes/castle.json 320

#include <slicecast/slicecast.h>

#include <cstdio>
#include <cstdlib>
#include <utility>

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: example-hits SCENE.json COLUMN\n");
        return 2;
    }
    slicecast::LoadResult loaded = slicecast::loadSceneFile(argv[1]);
    for (const slicecast::Fault& fault : loaded.faults)
        std::fprintf(stderr, "%s\n", slicecast::describe(fault).c_str());
    if (!loaded.scene) return 1;
    slicecast::Game game(std::move(*loaded.scene));

    std::printf("  depth  tile        level  heights      rows       block\n");
    for (const slicecast::ColumnHit& hit : game.hits(640, 400, std::atoi(argv[2]))) {
        std::printf("%7.2f  %4d, %-4d  %5d  %4.2f - %4.2f  ", hit.depth, hit.tileX, hit.tileY,
                    hit.level, hit.bottom, hit.top);
        if (hit.rows.empty()) {
            std::printf("hidden     ");
        } else {
            std::printf("%3d - %-3d  ", hit.rows.front().first, hit.rows.back().last - 1);
        }
        std::printf("%s\n", hit.block.c_str());
    }
}
