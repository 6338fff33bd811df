// Opens a window, or uses the page's canvas, and fills it with one colour.

#include <SDL2/SDL.h>

int main(int, char**) {
    if (SDL_Init(SDL_INIT_VIDEO) != 0) return 1;
    SDL_Window* window = SDL_CreateWindow("Slicecast", SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED, 640, 400, 0);
    if (window == nullptr) return 1;
    SDL_Surface* surface = SDL_GetWindowSurface(window);
    if (surface == nullptr) return 1;
    SDL_FillRect(surface, nullptr, SDL_MapRGB(surface->format, 96, 144, 200));
    SDL_UpdateWindowSurface(window);
    return 0;
}
