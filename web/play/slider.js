// Sliders of the engine's numbers: how far each goes, its own table of options says.
//
//     fitSliders(form, caster.optionList);       those of the form that have an option's name

const kPlaces = 40; // about so many at least that a slider can stand at

// In whole steps of a decimal place, which people can read.
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
