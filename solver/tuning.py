"""The numbers of the solver that are chosen, not derived: each with its name and its reason.

None of them belongs to one mesh. ``python scripts/bench_tuning.py`` doubles and halves each and
prints what changes on the meshes of the paper's authors; docs/tuning.md has what it printed.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Tuning:
    """How a net is looked for. Lengths are in mean edges, residuals dimensionless.

    Attributes:
        fade: factor on the guides from step to step: they lead for some twenty steps.
        fade_end: below this they are switched off, far below rounding of the constraints.
        near: with every residual below this, the net is reached without guides.
        patience: steps without progress, with the guides gone, after which an attempt counts as
            stuck;
        progress: it is made where the worst residual is less than this part of the least before.
        pace: by so many steps without guides the pace of an attempt at a rigid net is judged;
        hopeless: it is given up where it would go on for more steps than that.
        margin: stop this far below the tolerance: the last Gauss-Newton step costs little and
            squares the error;
        slow_margin: and only this far where it does not square it,
        slow: but leaves more than this part of the largest residual.
        hold: handles are followed with the guides at this factor, where the mesh is nearly a net,
        calm: until so many steps in turn
        rest: are this small: what follows depends on where the handles are, not on the way there;
        hold_steps: at most so many.
        hold_damping: damping of the first step after that, as if nothing had come before.
        live_damping: while a vertex is dragged no step is damped less: each refused one is a frame
            that comes late.
        damping_start: damping of the first step, in the scale of the normal equations, whose
            diagonal is about one.
        damping_min: least damping, above rounding.
        damping_max: damping from which on a step is too short to help.
        calmer: factor on the damping after a step that was accepted at once;
        harder: and after one that was refused,
        damping_refused: from this on.
        rounding: a step may raise the energy by this part of it,
        rounding_zero: and by so much for each unknown: residuals of 1e-13 are rounding.
        probe: part of the step at which the second derivative is probed.
        longest_bend: longest bend that is trusted, as part of the step.
        reuses: steps that follow with the same factors; more of them lag visibly behind a dragged
            vertex.
        memory: steps that relaxation remembers,
        memorable: where the slope along them changed by more than this part, which is rounding.
        relaxation_damping: keeps its matrix regular where scalars are free.
        shortest: shortest part of a step of relaxation that is tried,
        decrease: and the decrease that it has to bring, as part of what the slope promises,
        relaxation_rounding: but for this part of the energy.
        guard: weight that keeps edges and faces of guarded nets from collapsing and crossing over.
        guarded: edges shorter than this part of the shortest at the start are pushed back.
        upright: cosine between opposite edges of a face below which they are turned back.
        sheets: weights of evenness in the first attempts of sheets bent in one direction,
        domes: of doubly curved ones, which have to give up a curvature,
        bent: and of such from which it has been taken.
        smooth: third differences of a start up to which it has no noise to be smoothed away.
        rough: a start whose lines bend less evenly than this has noise in it,
        calming: and this weight of evenness draws them even, where a net would keep it.
        nearest_fairness: factors of the attempt that looks for the nearest net: on fairness
        nearest_closeness: and on closeness.
        fairer: factor on fairness of the attempts against collapse: once, and squared.
        drawn_even: so many of them at an easier net that is drawn even, where they hardly differ.
        keeping: weights of isometry in the attempts after one whose surface grew or shrank.
        handles: weight of handles.
        close_to: weight of a surface to stay close to, in closeness of one vertex.
        enough: of so many attempts that reached the net, though with short edges or creases, the
            best is taken.
        worth: a shape that is no solution replaces another when its worst residual is smaller by
            this factor: a little less of it is not worth wandering for.
        shrunk: a result whose shortest edge, relative to the input's, is shorter is a collapse.
        cramped: below this, another attempt with other guides is worth its time,
        creased: and where faces meet at more than this angle in degrees
        creasing: and so many times the input's,
        whole: and where the area is less than this part of the input's, or more than its inverse,
        even: and where lines zigzag: bend less evenly than this and than the input's
        uneven: by more than that,
        thick: and where a shape that was at least so thick, as part of its size,
        flattened: has less than this part of its thickness left.
        unlike: short edges count so much against a shape, where lost area counts one: they may
            come of a net that is finer in places.
        solid: a shape that was no plane to so much of its size,
        gone: and of whose thickness less than that is left, has gone.
        along_evenness: weight of lines that bend evenly in the last phase, where that of the
            distance from the surface is one,
        along_near: of a net that is nearly on the surface already,
        along_far: of one that has a long way to go across the curvature,
        along_rough: of such a one whose lines have no evenness to lose,
        along_early: of one that is led on early because its lines zigzag,
        along_evener: and in another attempt where they zigzag after that.
        slanted: nets of right angles whose corners are farther from upright than so many degrees,
            or that are not good, are led on along the nets to one more like the start;
        righting: from so many radians on corners are pushed back there,
        righted_evenness: with these weights of even lines, one after the other, until one will do,
        righted_border: with this one of the border,
        righted_guard: and with this one of what the guards keep.
        along_steps: the last phase takes as many steps as there were before, or so many:
        nearest_steps: more where to be near is what was asked for,
        early_steps: and where it comes early.
        alike: an early one makes other attempts needless where it kept this part of the area.
        still_whole: a net that is nearer but has less than this part of the area is less of what
            was drawn,
        still_roomy: as is one with edges shorter than this part,
        still_thick: and one flatter than this part, where the start itself was meant.
        dear: lines that are less even, or edges that are shorter, by more than this are too much
            for being nearer where nobody asked for it.
        lost: handles that lack more than this part of their way are pulled along the nets: others
            are near, and the mesh is not to jump when they are let go.
        futile: so many attempts that are given up as too slow are all.
        stages: weights of the pull that makes parts alike, where that of the distance is one;
        stage_steps: steps for each of them.
        kinds_evenness: weight of even lines meanwhile: that lengths jump works against it.
        kinds_borders: of the border, without which a net draws back to where the surface is
            simpler; the second where the first leads to too many kinds.
        kinds_tries: numbers of kinds that are tried, as parts of how many there were,
        kinds_fewer: and of rows that come out alike, as parts of what was asked for.
        stress_power: parts farther from their shape are pulled the more: sums of this power,
        least_stress: but none less than this part.
        kinds_rounds: rounds in which parts find their first kinds.
        far_off: what is farther off the surface than this part of its size is another shape, where
            nothing else was said.
        equal: with this residual parts of a kind are equal as far as numbers tell.
        on_surface: part of its size that a net may be off a surface where nobody says how much,
        in_reach: and how many times that for another last phase to be worth its time.
        long_way: part of its size off a surface from which on a net has a long way to go.
        peak: what is farther off than so many times the root mean square counts with its fourth
            power in an attempt that follows where the way is not long,
        peak_begin: once steps lower the wishes by less than this part of them,
        peak_worth: until they lower those fourth powers by less than this part: of the distances
            that is a quarter of a percent,
        peak_cost: and only where that costs no more than this of the evenness of lines,
        peak_even: or leaves this much of it.
        peak_late: part of the steps after which it follows where the way is long and lines have
            no evenness to lose.
        inside: part of a distance that is allowed from which on it weighs
        forbidden: so much more.
        along_motion: weight of neighbours that move alike along the nets, against zigzag for the
            last millimetre,
        along_closeness: of staying where they were, which decides only what nothing else does,
        along_squareness: of faces that are not sheared, as part of that of even lines,
        along_border: of the border, which a net across the curvature has to leave,
        along_guard: and of long edges, open faces and their corners, which feel nothing as long as
            they are so.
        slants: corners farther than this from upright, in radians, and than at the start are pushed
            back: faces that turn into triangles lie near, and are none of a quad net. The second
            where the last phase comes early.
        room: edges shorter than this part of the shortest at the start are pushed back,
        roomy: and than this where the net nearly is on its surface, so that none need give way.
        across: edges over which a surface rises by more than this part of their length cut across
            a crease or a step.
        share: of the wishes in the energy whose minimum a step along the nets aims at. The smaller,
            the better it keeps to the net; rounding is the limit.
        tangent: added to the constraints' own matrix, which alone says nothing of motions along
            the net.
        along_damping_start: damping of the first such step,
        along_damping_min: the least, above rounding,
        along_damping_max: and that from which on it is too short to help;
        along_calmer: factor on it after a step that was accepted at once and kept
        kept_much: more than this part of what it promised,
        along_harder: and after one that was refused or kept
        kept_little: less than this part,
        along_refused: from this on.
        along_longest: a longer step leaves the neighbourhood that it was made for.
        corrections: back onto the net with the same factors, at most so many,
        on_net: until this residual;
        near_net: with one larger than this the step is none along the net: the way back from there
            may cost more than the next one gains;
        off_net: it is brought back with new factors then, from farther off than this not at all.
        along_worth: steps that lower the wishes by less than this part of them are not worth their
            time,
        along_enough: nor is what follows on one that promised less than this,
        undamped: where damping took less than this part of the promise.
        last_corrections: at the end, to the last digit,
        shrinking: with new factors where moves do not shrink to this part of the one before,
        most_corrections: and so many where the residual is still larger
        exact: than this;
        last_tangents: with these parts of what is added: fewer digits of a nearly singular matrix
            at first, then the last.
        crumpled: of a net whose lines bend less evenly than this,
        crumpling: or by so much less than the start's, it is said that they zigzag.
        border_left: a border that is farther from where it was is another one.
        opened: what meets without being joined, and is now further apart, has come apart.
        line: a plane that is narrower than this part of its length is called a line.
        moved: a shape is another one where a vertex moved farther than this,
        moved_of_all: and farther than this part of the bounding box's diagonal,
        resized: or a side of the box changed by more than this part of it.
        another: what is farther from its design surface than this part of its size is not fit to
            be built.
        contradiction: residuals of what cannot move at all are the rounding of a file up to this,
            and are refused from there on.
    """

    fade: float = 0.3
    fade_end: float = 1e-12
    near: float = 1e-6
    patience: int = 25
    progress: float = 0.5
    pace: int = 20
    hopeless: int = 100
    margin: float = 1e-2
    slow_margin: float = 0.25
    slow: float = 0.5
    hold: float = 3e-3
    calm: int = 2
    rest: float = 1e-10
    hold_steps: int = 250
    hold_damping: float = 1e-9
    live_damping: float = 1e-5
    damping_start: float = 1e-3
    damping_min: float = 1e-12
    damping_max: float = 1e8
    calmer: float = 0.25
    harder: float = 8.0
    damping_refused: float = 1e-9
    rounding: float = 1e-9
    rounding_zero: float = 1e-26
    probe: float = 0.1
    longest_bend: float = 0.375
    reuses: int = 3
    memory: int = 10
    memorable: float = 1e-14
    relaxation_damping: float = 1e-9
    shortest: float = 1e-3
    decrease: float = 2e-4
    relaxation_rounding: float = 1e-12
    guard: float = 0.1
    guarded: float = 0.6
    upright: float = 0.3
    sheets: tuple[float, ...] = (0.3, 3.0)
    domes: tuple[float, ...] = (30.0, 3.0, 0.3)
    bent: tuple[float, ...] = (3.0, 30.0, 0.3)
    smooth: float = 0.05
    rough: float = 0.1
    calming: float = 1.0
    nearest_fairness: float = 0.1
    nearest_closeness: float = 10.0
    fairer: float = 10.0
    drawn_even: int = 2
    keeping: tuple[float, ...] = (0.3, 3.0)
    handles: float = 10.0
    close_to: float = 30.0
    enough: int = 3
    worth: float = 0.8
    shrunk: float = 0.25
    cramped: float = 0.5
    creased: float = 30.0
    creasing: float = 2.0
    whole: float = 0.92
    even: float = 0.85
    uneven: float = 0.05
    thick: float = 0.02
    flattened: float = 0.4
    unlike: float = 0.5
    solid: float = 5e-3
    gone: float = 0.1
    along_evenness: float = 0.04
    along_near: float = 0.07
    along_far: float = 0.08
    along_rough: float = 0.8
    along_early: float = 0.1
    along_evener: float = 1.0
    slanted: float = 30.0
    righting: float = 0.47
    righted_evenness: tuple[float, ...] = (1.0, 0.1)
    righted_border: float = 0.3
    righted_guard: float = 10.0
    along_steps: int = 24
    nearest_steps: int = 60
    early_steps: int = 40
    alike: float = 0.95
    still_whole: float = 0.85
    still_roomy: float = 0.4
    still_thick: float = 0.5
    dear: float = 0.01
    lost: float = 0.5
    futile: int = 2
    stages: tuple[float, ...] = (1.0, 30.0, 1e3, 3e4)
    stage_steps: int = 25
    kinds_evenness: float = 0.3
    kinds_borders: tuple[float, ...] = (0.3, 0.01)
    kinds_tries: tuple[float, ...] = (0.5, 0.25, 0.12)
    kinds_fewer: tuple[float, ...] = (1.0, 0.85)
    stress_power: float = 4.0
    least_stress: float = 0.1
    kinds_rounds: int = 30
    far_off: float = 0.02
    equal: float = 1e-11
    on_surface: float = 4.5e-4
    in_reach: float = 6.0
    long_way: float = 0.015
    peak: float = 1.5
    peak_begin: float = 0.05
    peak_worth: float = 0.01
    peak_cost: float = 0.04
    peak_even: float = 0.9
    peak_late: float = 0.67
    inside: float = 0.8
    forbidden: float = 100.0
    along_motion: float = 1e-3
    along_closeness: float = 1e-5
    along_squareness: float = 0.3
    along_border: float = 1e-2
    along_guard: float = 0.3
    slants: tuple[float, ...] = (0.9, 0.6)
    room: float = 0.6
    roomy: float = 0.85
    across: float = 0.2
    share: float = 1e-4
    tangent: float = 1e-7
    along_damping_start: float = 1e-6
    along_damping_min: float = 1e-11
    along_damping_max: float = 1e2
    along_calmer: float = 0.25
    kept_much: float = 0.75
    along_harder: float = 4.0
    kept_little: float = 0.25
    along_refused: float = 1e-9
    along_longest: float = 1.0
    corrections: int = 6
    on_net: float = 1e-9
    near_net: float = 1e-7
    off_net: float = 1e-2
    along_worth: float = 3e-4
    along_enough: float = 5e-3
    undamped: float = 0.4
    last_corrections: int = 5
    shrinking: float = 0.1
    most_corrections: int = 25
    exact: float = 1e-12
    last_tangents: tuple[float, ...] = (1e-3, 1e-5)
    crumpled: float = 0.35
    crumpling: float = 0.25
    border_left: float = 1.0
    opened: float = 1e-4
    line: float = 1e-2
    moved: float = 0.5
    moved_of_all: float = 0.05
    resized: float = 0.1
    another: float = 0.01
    contradiction: float = 1e-6
