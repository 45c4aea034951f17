// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/registry.h>
#include <pellicle/potentials/effect.h>

namespace pellicle
{
/** Names of effects and how to make them. Applications of one's own add theirs: `library.add("my effect", factory)`. */
using EffectLibrary = Registry<Effect>;

/** The effects that Pellicle ships: the one readable list. */
EffectLibrary standard_effects();
/** Those of drops. */
EffectLibrary droplet_effects();
/** Those of drops on soft substrates. */
EffectLibrary ridge_effects();
/** Those of membranes with directors and of Cosserat shells: the standard ones, and their own. */
EffectLibrary director_effects();
} // namespace pellicle
