// Limits on foreign maps. They bound memory and time for any file; most are the engine's own, from
// src/world/limits.h and src/scene/limits.h, so that each scene that is made can be loaded.

export const kMostFileBytes = 2 ** 26; // of one file, as the engine's of a picture
export const kMostXmlBytes = 2 ** 24; // an element takes some 20 times its text while it is read
export const kMostFiles = 1024; // that one map names: tilesets, pictures, templates, levels
export const kMostAllFileBytes = 2 ** 28; // of all of these together
export const kMostNesting = 32; // of groups of layers, and of values of classes
export const kMostFrames = 64; // of an animated tile
export const kMostSide = 4096; // tiles, west to east and north to south
export const kMostLevels = 32;
export const kMostMaps = 256;
export const kMostTiles = 2 ** 25; // as read and as kept: a layer of the largest map is half
export const kMostCells = 64_000_000; // width * depth * levels of all maps of a scene
export const kMostObjects = 65_536;
export const kMostKinds = 65_535; // a blueprint's number has 16 bits
export const kMostLegend = 4096; // characters
export const kMostLayers = 1024; // of all kinds
export const kMostPictureSide = 16_384; // texels, of a picture from which tiles are cut
export const kMostPictureTexels = 2 ** 25; // of one, and so 128 MB
export const kMostAllPictureTexels = 2 ** 26; // of all of these
export const kMostSceneTexels = 2 ** 26; // of all pictures that a scene names
export const kLeastTextureSide = 8; // texels
export const kMostTextureSide = 1024;
export const kMostName = 100; // characters
export const kMostTitle = 200;
export const kMostMessage = 300;
export const kMostMessages = 1024; // of one map
export const kMostNotes = 1000; // lines about what was not taken; a longer list helps nobody
