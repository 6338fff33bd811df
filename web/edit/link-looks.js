// How each kind of link is drawn, in the plan, in its legend and in the picture.
// Gives colours and words.

export const kLinkLooks = {
  portal: { colour: '#b58cf0', label: 'Portal' },
  gate: { colour: '#f0a34a', label: 'Gate' },
  mover: { colour: '#d9c3a0', label: 'Moving block' },
  way: { colour: '#62d6c4', label: 'Way' },
  message: { colour: '#7fc4e8', label: 'Message' },
  find: { colour: '#f4e46a', label: 'Find' },
  goal: { colour: '#ff9ab8', label: 'Goal' },
};
