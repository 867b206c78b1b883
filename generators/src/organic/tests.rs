//! Topology, embedding and shape of organic surfaces.

use super::*;
use crate::check::{
    assert_distinct_positions, assert_embedded, assert_oriented, determinant, signed_volume,
};
use crate::testing::draws;
use std::collections::HashMap;

#[test]
fn genus_and_number_of_vertices_are_exact() {
    for (seed, genus) in [0, 1, 2, 5, 16, 17, 104].into_iter().enumerate() {
        let minimum = minimum_vertices(genus) as u32;
        for at_least in [0, minimum, minimum + 333] {
            let surface = surface(genus, at_least, &mut draws(seed as u64));
            assert_eq!(surface.positions.len() as u32, at_least.max(minimum));
            assert_oriented(&surface, genus as usize);
            assert_distinct_positions(&surface);
        }
    }
}

#[test]
fn surfaces_do_not_pass_through_themselves() {
    for genus in [0, 1, 2, 4, 5, 23] {
        for seed in 0..4 {
            for more in [0, 700] {
                let at_least = minimum_vertices(genus) as u32 + more;
                let surface = surface(genus, at_least, &mut draws(seed));
                assert_embedded(&surface);
                assert!(signed_volume(&surface) > 0.0);
            }
        }
    }
}

/// Displacements keep volumes, and the thickness is scaled by 1 on average.
#[test]
fn volumes_are_about_those_of_the_rounded_boxes() {
    for genus in [0, 1, 5, 30] {
        let mut smooth = BoxShape { cavities: 0, holes: genus, vertices: 5000 }.surface().unwrap();
        let rounding = Rounding::new(genus);
        smooth.positions.iter_mut().for_each(|p| *p = rounding.apply(*p));
        for seed in 0..4 {
            let warped = surface(genus, 5000, &mut draws(seed));
            let ratio = signed_volume(&warped) / signed_volume(&smooth);
            assert!((0.7..1.4).contains(&ratio), "{genus} {seed} {ratio}");
        }
    }
}

/// A crease along a ring or a row of holes would be an edge in a few hundred.
#[test]
fn fine_surfaces_have_no_creases() {
    for (genus, seed) in [(0, 1), (1, 2), (5, 3)] {
        let surface = surface(genus, 20_000, &mut draws(seed));
        let cosines = cosines(&surface);
        let sharp = cosines.iter().filter(|&&cosine| cosine < 0.9).count();
        assert!(sharp * 500 < cosines.len(), "{genus}: {sharp} of {}", cosines.len());
    }
}

/// For each edge the cosine between the normals of its triangles.
fn cosines(surface: &Surface) -> Vec<f64> {
    let mut across = HashMap::new();
    let mut cosines = Vec::new();
    for &[a, b, c] in &surface.triangles {
        let normal = normal(surface, [a, b, c]);
        for [u, v] in [[a, b], [b, c], [c, a]] {
            across.insert([u, v], normal);
            if let Some(other) = across.get(&[v, u]) {
                let dot: f64 = (0..3).map(|axis| normal[axis] * other[axis]).sum();
                cosines.push(dot / (length(normal) * length(*other)));
            }
        }
    }
    cosines
}

/// A normal twice as long as the triangle is large.
fn normal(surface: &Surface, triangle: [u32; 3]) -> [f64; 3] {
    let [a, b, c] = triangle.map(|v| surface.positions[v as usize]);
    let [p, q] = [b, c].map(|o| [o[0] - a[0], o[1] - a[1], o[2] - a[2]]);
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| determinant(axis, p, q))
}

fn length(vector: [f64; 3]) -> f64 {
    vector.iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[test]
fn triangles_are_of_similar_size() {
    for genus in [0, 1, 5, 65] {
        let surface = surface(genus, 20_000, &mut draws(genus.into()));
        let area = |&triangle: &[u32; 3]| length(normal(&surface, triangle));
        let mut areas: Vec<_> = surface.triangles.iter().map(area).collect();
        areas.sort_by(f64::total_cmp);
        let [low, median, high] = [1, 50, 99].map(|percent| areas[areas.len() * percent / 100]);
        assert!(low > 0.3 * median && high < 2.5 * median, "{genus}: {low} {median} {high}");
        assert!(areas[0] > 0.02 * median, "{genus}: {} of {median}", areas[0]);
    }
}

#[test]
fn equal_draws_give_equal_surfaces() {
    let [a, b, c] = [1, 1, 2].map(|seed| surface(3, 2000, &mut draws(seed)));
    assert_eq!(a, b);
    assert_ne!(a.positions, c.positions);
    assert_eq!(a.triangles, c.triangles);
}

/// All bits of all coordinates, folded into one number, as computed on x86-64.
#[test]
fn is_the_same_on_every_platform() {
    for (genus, known) in [(0, 0xf4b2_6d9b_e4ef_0607), (5, 0x07d2_f515_50da_8d4c)] {
        let surface = surface(genus, 0, &mut draws(1));
        let fold = |sum: u64, x: &f64| (sum ^ x.to_bits()).wrapping_mul(0x0000_0100_0000_01b3);
        let found = surface.positions.as_flattened().iter().fold(0xcbf2_9ce4_8422_2325, fold);
        assert_eq!(found, known, "genus {genus}: {found:#x}");
    }
}
