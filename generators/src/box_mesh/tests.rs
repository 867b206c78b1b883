use super::*;
use crate::check::{assert_distinct_positions, assert_oriented, degrees, signed_volume};

fn build(cavities: u32, holes: u32, vertices: u32) -> Surface {
    BoxShape { cavities, holes, vertices }.surface().unwrap()
}

#[test]
fn first() {
    for (cavities, holes) in [(0, 0), (0, 1), (1, 0), (20, 0), (3, 4), (0, 9)] {
        let minimum = BoxShape::minimum_vertices(cavities, holes) as u32;
        for vertices in minimum..minimum + 500 {
            let s = build(cavities, holes, vertices);
            assert_eq!(s.positions.len() as u32, vertices);
            assert_oriented(&s, holes as usize);
            assert_distinct_positions(&s);
            assert!(signed_volume(&s) > 0.0);
        }
    }
    let s = build(3844, 0, 2_097_150);
    let d = degrees(&s);
    println!("{}", d.iter().filter(|&&d| d == 6).count() as f64 / d.len() as f64);
}
