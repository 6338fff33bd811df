// Sets the ranges of sliders from the engine's table of options.
//
//     fitSliders(form, caster.optionList);       for all sliders named after an option

const kPlaces = 40; // a slider has at least about so many positions

// A power of ten, so that values are easy to read.
export function stepOf({ kind, least, greatest }) {
  const decimals = Math.ceil(-Math.log10((greatest - least) / kPlaces));
  return kind === 'wholeNumber' ? 1 : Number(`1e${-decimals}`);
}

export function fitSliders(form, options) {
  for (const option of options) {
    const field = form.querySelector(`input[type="range"][name="${option.name}"]`);
    if (field === null) continue;
    const { value } = field;
    Object.assign(field, { min: option.least, max: option.greatest, step: stepOf(option) });
    Object.assign(field, { value, disabled: false });
  }
}
