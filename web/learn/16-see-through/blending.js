// The formula of the chapter, for the figure and the exercises.

// A layer's channel over what is behind it; whole numbers from 0 to 255.
export const over = (pane, alpha, behind) =>
  Math.floor((pane * alpha + behind * (255 - alpha) + 127) / 255);

export const layOver = (pane, alpha, behind) =>
  pane.map((channel, i) => over(channel, alpha, behind[i]));
