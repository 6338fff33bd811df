// Plays recorded inputs natively.
//
//     slicecast-replay SCENE WIDTH HEIGHT PICTURES < INPUTS
//     slicecast-replay SCENE WIDTH HEIGHT PICTURES RECORDING
//
// Each line of the inputs is a number of steps and what is asked for during them, in the order of
// slicecast_step (src/wasm/bindings.h). After each line the state's fingerprint is printed, and the
// picture (R, G, B, A, no padding) is added to the file PICTURES. Of a recording the same after
// each of its marks and at its end.

#include "base/image.h"
#include "files/recording_file.h"
#include "files/scene_file.h"
#include "session/session.h"

#include <cinttypes>
#include <cstdio>
#include <cstdlib>

using namespace slicecast;

int main(int argc, char** argv) {
    if (argc != 5 && argc != 6) return 2;
    LoadedScene loaded = readSceneFile(argv[1]);
    for (const Fault& fault : loaded.faults) std::fprintf(stderr, "%s\n", describe(fault).c_str());
    if (!loaded.world) return 1;
    Session session(std::move(*loaded.world));
    Image picture(std::atoi(argv[2]), std::atoi(argv[3]));
    std::FILE* pictures = std::fopen(argv[4], "wb");
    if (pictures == nullptr) return 1;

    const auto show = [&] {
        session.draw({picture.pixels.data(), picture.width, picture.height, picture.width});
        std::printf("%016" PRIx64 "\n", session.fingerprint());
        std::fwrite(picture.pixels.data(), sizeof(Pixel), picture.pixels.size(), pictures);
    };
    if (argc == 6) {
        ReadRecording read = readRecordingFile(argv[5]);
        for (const Fault& fault : read.faults)
            std::fprintf(stderr, "%s\n", describe(fault).c_str());
        if (!read.recording) return 1;
        Replay replay(std::move(*read.recording));
        std::size_t passed = 0;
        while (replay.step(session)) {
            for (; passed < replay.marks().size(); ++passed) show();
        }
        show();
        return std::fclose(pictures) == 0 && replay.isSame() ? 0 : 1;
    }

    int steps = 0;
    int buttons = 0;
    Input input;
    while (std::scanf("%d %lf %lf %lf %lf %lf %lf %lf %d", &steps, &input.forward, &input.strafe,
                      &input.turn, &input.look, &input.fly, &input.turnDegrees, &input.lookHeights,
                      &buttons) == 9) {
        input.jump = (buttons & 1) != 0;
        input.fast = (buttons & 2) != 0;
        input.slow = (buttons & 4) != 0;
        input.use = (buttons & 8) != 0;
        input.open = (buttons & 16) != 0;
        input.close = (buttons & 32) != 0;
        for (int step = 0; step < steps; ++step) session.step(input);
        show();
    }
    return std::fclose(pictures) == 0 ? 0 : 1;
}
