// Plays a scene in a window: the arrows walk and turn, Space jumps, Escape ends it.
//
//     example-window assets/scenes/castle.json
//     example-window assets/scenes/castle.json 10        ends after 10 pictures

#include <slicecast/slicecast.h>

#include <SDL.h>

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace {

constexpr int kWidth = 960;
constexpr int kHeight = 600;

// The input of the keys that are held.
slicecast::Input input() {
    const Uint8* keys = SDL_GetKeyboardState(nullptr);
    return {.forward = 1.0 * keys[SDL_SCANCODE_UP] - keys[SDL_SCANCODE_DOWN],
            .turn = 1.0 * keys[SDL_SCANCODE_RIGHT] - keys[SDL_SCANCODE_LEFT],
            .jump = keys[SDL_SCANCODE_SPACE] != 0};
}

bool isClosed() {
    for (SDL_Event event; SDL_PollEvent(&event) != 0;) {
        if (event.type == SDL_QUIT) return true;
        if (event.type == SDL_KEYDOWN && event.key.keysym.sym == SDLK_ESCAPE) return true;
    }
    return false;
}

// Shows this many pictures; if `pictures` is negative, shows them until the window is closed.
void play(slicecast::Game& game, SDL_Window* window, long pictures) {
    SDL_Renderer* renderer = SDL_CreateRenderer(window, -1, 0);
    SDL_Texture* shown = SDL_CreateTexture(renderer, SDL_PIXELFORMAT_ABGR8888,
                                           SDL_TEXTUREACCESS_STREAMING, kWidth, kHeight);
    slicecast::Image image(kWidth, kHeight);
    const Uint64 begin = SDL_GetTicks64();
    for (long picture = 0; picture != pictures && !isClosed(); ++picture) {
        // Catch up with the clock
        const Uint64 steps = (SDL_GetTicks64() - begin) * slicecast::kStepsEachSecond / 1000;
        while (static_cast<Uint64>(game.steps()) < steps) game.step(input());
        game.draw(image.view());
        SDL_UpdateTexture(shown, nullptr, image.pixels.data(), kWidth * 4);
        SDL_RenderCopy(renderer, shown, nullptr, nullptr);
        SDL_RenderPresent(renderer);
    }
    SDL_DestroyTexture(shown);
    SDL_DestroyRenderer(renderer);
}

}  // namespace

int main(int argc, char** argv) {
    slicecast::LoadResult loaded = slicecast::loadSceneFile(argc > 1 ? argv[1] : "");
    for (const slicecast::Fault& fault : loaded.faults)
        std::fprintf(stderr, "%s\n", slicecast::describe(fault).c_str());
    if (!loaded.scene || SDL_Init(SDL_INIT_VIDEO) != 0) return 1;

    slicecast::Game game(std::move(*loaded.scene));
    SDL_Window* window = SDL_CreateWindow(game.title().c_str(), SDL_WINDOWPOS_CENTERED,
                                          SDL_WINDOWPOS_CENTERED, kWidth, kHeight, 0);
    if (window != nullptr) play(game, window, argc > 2 ? std::atol(argv[2]) : -1);
    SDL_DestroyWindow(window);
    SDL_Quit();
    return window != nullptr ? 0 : 1;
}
