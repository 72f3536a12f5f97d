//! In which order the cases are measured, so that neither drift nor neighbours favour one.
//!
//! A machine grows warm, other programs come and go, and a run finds the caches and the memory as the run before it left
//! them. Each round measures every case once, and the rounds follow a design in which every case stands at every place
//! equally often and comes right after every other case equally often: E. J. Williams, Experimental Designs Balanced for
//! the Estimation of Residual Effects of Treatments, 1949.

/// The cases of a round, in the order in which they are measured: each of `0..cases` once.
///
/// The balance is complete after `cases` rounds if that number is even, and after twice as many if it is odd.
#[must_use]
pub fn order(cases: usize, round: usize) -> Vec<usize> {
    if cases == 0 {
        return Vec::new();
    }
    // 0, 1, n-1, 2, n-2, ...: all differences of neighbours differ. An odd number needs the mirrored rows as well.
    let zigzag = |place: usize| if place % 2 == 1 { place.div_ceil(2) } else { cases - place / 2 };
    let (turn, mirrored) = if cases.is_multiple_of(2) { (round, false) } else { (round / 2, round % 2 == 1) };
    let mut row: Vec<usize> = (0..cases).map(|place| (zigzag(place) + turn % cases) % cases).collect();
    if mirrored {
        row.reverse();
    }
    row
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_round_visits_every_case_once() {
        for cases in 0..20 {
            for round in 0..50 {
                let mut row = order(cases, round);
                row.sort_unstable();
                assert!(row.into_iter().eq(0..cases), "{cases} cases, round {round}");
            }
        }
    }

    #[test]
    fn every_case_stands_at_every_place_and_follows_every_other_equally_often() {
        for cases in 2..20_usize {
            let times = 1 + cases % 2;
            let mut places = vec![vec![0; cases]; cases];
            let mut followers = vec![vec![0; cases]; cases];
            for round in 0..cases * times {
                let row = order(cases, round);
                row.iter().enumerate().for_each(|(place, &case)| places[case][place] += 1);
                row.windows(2).for_each(|pair| followers[pair[0]][pair[1]] += 1);
            }
            assert!(places.iter().flatten().all(|&n| n == times), "{cases}: {places:?}");
            for (before, counts) in followers.iter().enumerate() {
                for (after, &count) in counts.iter().enumerate() {
                    assert_eq!(count, if before == after { 0 } else { times }, "{cases}: {before} before {after}");
                }
            }
        }
    }
}
