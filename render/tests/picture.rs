//! Pictures: what is covered, what hides what, and that nothing else comes into it.

use proptest::prelude::*;
use triquad_generators::{Surface, classic, grids};
use triquad_render::{Camera, Image, Lines, Picture, PictureError, Polygons, Section};

/// A mesh that owns the arrays to draw.
#[derive(Clone, Default)]
struct Mesh {
    positions: Vec<[f64; 3]>,
    corners: Vec<u32>,
    ends: Vec<u32>,
}

impl Mesh {
    fn push(&mut self, face: &[u32]) {
        self.corners.extend_from_slice(face);
        self.ends.push(self.corners.len() as u32);
    }

    fn view(&self) -> Polygons<'_> {
        Polygons::mixed(&self.positions, &self.corners, &self.ends)
    }
}

const RED: [u8; 3] = [200, 20, 20];
const GREEN: [u8; 3] = [20, 200, 20];

/// From infinity along an axis, on a transparent ground, faces only.
fn plain(mesh: &Mesh, direction: [f64; 3]) -> Picture<'_> {
    Picture {
        width: 200,
        height: 200,
        camera: Camera { direction, distance: None, margin: 0.05, ..Camera::default() },
        background: None,
        lines: Lines { edges: false, ..Lines::default() },
        depth_shade: 0.0,
        ..Picture::new(mesh.view())
    }
}

/// The quads of [-1, 1]³, counter-clockwise from outside; vertex x + 2y + 4z.
fn cube() -> Mesh {
    let corner = |v: u32| [0, 1, 2].map(|i| f64::from(v >> i & 1) * 2.0 - 1.0);
    let quads =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    polygons((0..8).map(corner).collect(), &quads.map(|quad| quad.to_vec()))
}

/// Squares across the z axis, counter-clockwise from +z: half side and height.
fn squares(squares: &[(f64, f64)]) -> Mesh {
    let corners = |&(r, z): &(f64, f64)| [[-r, -r, z], [r, -r, z], [r, r, z], [-r, r, z]];
    let positions = squares.iter().flat_map(corners).collect();
    let faces = (0..squares.len() as u32).map(|face| [0, 1, 2, 3].map(|i| 4 * face + i).to_vec());
    polygons(positions, &faces.collect::<Vec<_>>())
}

fn polygons(positions: Vec<[f64; 3]>, faces: &[Vec<u32>]) -> Mesh {
    let mut mesh = Mesh { positions, ..Mesh::default() };
    faces.iter().for_each(|face| mesh.push(face));
    mesh
}

fn face_list(surface: Surface) -> Mesh {
    polygons(surface.positions, &surface.triangles.iter().map(|t| t.to_vec()).collect::<Vec<_>>())
}

/// Covered area in pixels.
fn area(image: &Image) -> f64 {
    image.pixels().iter().map(|pixel| f64::from(pixel[3]) / 255.0).sum()
}

fn assert_near(value: f64, expected: f64, share: f64) {
    assert!((value - expected).abs() <= share * expected, "{value} is not about {expected}");
}

fn brightness(image: &Image) -> f64 {
    let all = image.pixels().as_flattened().iter().map(|&x| f64::from(x)).sum::<f64>();
    all / (4 * image.pixels().len()) as f64
}

#[test]
fn a_sphere_covers_a_disc() {
    let sphere = face_list(grids::sphere(60));
    for (distance, samples) in [(None, 1), (None, 4), (Some(3.0), 3)] {
        let mut picture = plain(&sphere, [0.3, 0.5, 1.0]);
        picture.camera.distance = distance;
        picture.samples = samples;
        let radius = 90.0;
        assert_near(area(&picture.draw().unwrap()), std::f64::consts::PI * radius * radius, 0.01);
    }
}

#[test]
fn a_cube_covers_a_square_or_a_hexagon() {
    let cube = cube();
    assert_near(area(&plain(&cube, [0.0, 0.0, 2.0]).draw().unwrap()), 180.0 * 180.0, 1e-6);
    // Seen along its diagonal: a hexagon of side √(8/3), twice as high.
    let hexagon = area(&plain(&cube, [1.0; 3]).draw().unwrap());
    assert_near(hexagon, 1.5 * 3f64.sqrt() * 90.0 * 90.0, 0.01);
}

#[test]
fn margin_zoom_and_target_move_what_is_seen() {
    let flat = squares(&[(1.0, 0.0)]);
    let mut picture = plain(&flat, [0.0, 0.0, 1.0]);
    picture.camera.margin = 0.25;
    assert_near(area(&picture.draw().unwrap()), 100.0 * 100.0, 1e-6);
    picture.camera.zoom = 0.5;
    assert_near(area(&picture.draw().unwrap()), 50.0 * 50.0, 1e-6);
    picture.camera.target = Some([1.0, 1.0, 0.0]);
    let corner = picture.draw().unwrap();
    // The corner is in the middle, the square below it on the left.
    let opaque = [(98, 101), (101, 101), (98, 98), (101, 98)].map(|(x, y)| corner.pixel(x, y)[3]);
    assert_eq!(opaque, [255, 0, 0, 0]);
}

#[test]
fn the_front_hides_the_back_in_any_order() {
    for (mesh, colours) in [
        (squares(&[(1.0, 1.0), (1.0, -1.0)]), [RED, GREEN]),
        (squares(&[(1.0, -1.0), (1.0, 1.0)]), [GREEN, RED]),
    ] {
        let seen = |z: f64| {
            let picture = Picture { face_colours: &colours, ..plain(&mesh, [0.0, 0.0, z]) };
            let [red, green, _, opacity] = picture.draw().unwrap().pixel(100, 100);
            assert_eq!(opacity, 255);
            (red, green)
        };
        let (red, green) = seen(1.0);
        assert!(red / 4 > green);
        // From below it is the other square that is seen, from behind.
        let (red, green) = seen(-1.0);
        assert!(red > green && green > 40);
    }
}

#[test]
fn edges_are_seen_in_front_and_not_behind() {
    let lines = Lines { colour: [0; 3], opacity: 1.0, width: 2.0, ..Lines::default() };
    // A small square above or below a large one.
    for (height, visible) in [(0.1, true), (-0.1, false)] {
        for (distance, width) in [(None, 3.0), (Some(3.0), 3.0), (Some(3.0), 0.0)] {
            let mesh = squares(&[(1.0, 0.0), (0.5, height)]);
            let mut picture = plain(&mesh, [0.2, 0.1, 1.0]);
            picture.camera.distance = distance;
            picture.lines = Lines { width, ..lines.clone() };
            let image = picture.draw().unwrap();
            let dark = |x: usize, y: usize| image.pixel(x, y)[0] < 60 && image.pixel(x, y)[3] > 0;
            let inside = (30..170).flat_map(|y| (30..170).map(move |x| (x, y)));
            let count = inside.filter(|&(x, y)| dark(x, y)).count();
            // Four sides of about 90 pixels each, three wide; of width 0 there are none.
            let expected = if visible && width > 0.0 { 600..1300 } else { 0..1 };
            assert!(expected.contains(&count), "{count} dark pixels at height {height}");
        }
    }
}

#[test]
fn lines_along_the_outline_are_whole() {
    let cube = cube();
    for distance in [None, Some(2.0)] {
        let mut picture = plain(&cube, [0.7, 0.5, 1.0]);
        picture.camera.distance = distance;
        picture.lines = Lines { colour: [0; 3], opacity: 1.0, width: 3.0, ..Lines::default() };
        let image = picture.draw().unwrap();
        let mut outline = 0;
        for (y, x) in (1..199).flat_map(|y| (1..199).map(move |x| (y, x))) {
            let beside = [(x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1)];
            let open = beside.iter().any(|&(x, y)| image.pixel(x, y)[3] == 0);
            if image.pixel(x, y)[3] > 0 && open {
                outline += 1;
                assert!(image.pixel(x, y)[0] < 40, "{:?} at {x}, {y}", image.pixel(x, y));
            }
        }
        assert!(outline > 400);
    }
}

#[test]
fn highlighted_edges_have_their_colour_and_hide_too() {
    let mesh = squares(&[(1.0, 0.0), (0.5, 0.2), (0.5, -0.2)]);
    for (diagonal, visible) in [([4, 6], true), ([8, 10], false)] {
        let highlights = [diagonal];
        let picture = Picture { highlights: &highlights, ..plain(&mesh, [0.0, 0.0, 1.0]) };
        let [red, green, ..] = picture.draw().unwrap().pixel(100, 100);
        assert_eq!(red / 2 > green, visible);
    }
}

#[test]
fn edges_of_a_dense_mesh_do_not_blacken_it() {
    let darkening = |rows: u32| {
        let sphere = face_list(grids::sphere(rows));
        let faces = plain(&sphere, [0.0, 0.3, 1.0]);
        let lines = Lines { opacity: 1.0, colour: [0; 3], ..Lines::default() };
        let both = Picture { lines, ..faces.clone() };
        brightness(&faces.draw().unwrap()) - brightness(&both.draw().unwrap())
    };
    assert!(darkening(12) > 5.0);
    assert!(darkening(200).abs() < 0.1);
}

#[test]
fn a_section_shows_the_inside_and_cuts_faces_exactly() {
    let cube = cube();
    let mut picture = plain(&cube, [0.0, 0.0, 1.0]);
    let [red, _, blue, _] = picture.draw().unwrap().pixel(100, 100);
    assert!(red < blue);
    picture.section = Some(Section { point: [0.0, 0.0, 0.2], normal: [0.0, 0.0, 5.0] });
    let [red, _, blue, opacity] = picture.draw().unwrap().pixel(100, 100);
    assert!(red > blue + 40 && opacity == 255);

    picture.section = Some(Section { point: [0.3, 0.0, 0.0], normal: [1.0, 0.0, 0.0] });
    let cut = picture.draw().unwrap();
    assert_near(area(&cut), 0.65 * 180.0 * 180.0, 1e-4);
    picture.section = Some(Section { point: [0.0; 3], normal: [1.0, 1.0, 0.0] });
    assert_near(area(&picture.draw().unwrap()), 180.0 * 180.0 / 2.0, 0.01);
    // Nothing left is an empty picture.
    picture.section = Some(Section { point: [-9.0; 3], normal: [1.0, 0.0, 0.0] });
    assert!(area(&picture.draw().unwrap()) == 0.0);
}

#[test]
fn a_quad_with_a_dent_keeps_it() {
    let dart = vec![[0.0, 1.0, 0.0], [-1.0, -1.0, 0.0], [0.0, -0.5, 0.0], [1.0, -1.0, 0.0]];
    for turn in 0..4 {
        let mesh = polygons(dart.clone(), &[(0..4).map(|i| (i + turn) % 4).collect()]);
        let image = plain(&mesh, [0.0, 0.0, 1.0]).draw().unwrap();
        // (2 · 2 / 2 - 2 · 0.5 / 2) units of 90 pixels a side.
        assert_near(area(&image), 1.5 * 90.0 * 90.0, 0.01);
    }
}

#[test]
fn degenerate_faces_and_unused_vertices_leave_no_trace() {
    let clean = plain(&cube(), [0.5, 0.4, 1.0]).draw().unwrap();
    let mut mesh = cube();
    mesh.positions.push([f64::NAN; 3]);
    mesh.positions.push([50.0; 3]);
    [&[0, 0, 7][..], &[1, 1, 1, 1], &[2, 5], &[3], &[]].iter().for_each(|face| mesh.push(face));
    assert!(plain(&mesh, [0.5, 0.4, 1.0]).draw().unwrap() == clean);
    let point = polygons(vec![[3.0; 3]], &[vec![0, 0, 0]]);
    assert_eq!(area(&plain(&point, [0.5, 0.4, 1.0]).draw().unwrap()), 0.0);
}

#[test]
fn hollows_are_darker_and_plains_are_not() {
    let shaded = |mesh: &Mesh, depth_shade: f64| {
        let picture = Picture { depth_shade, ..plain(mesh, [0.0, 0.0, 1.0]) };
        picture.draw().unwrap().pixel(100, 100)
    };
    let plane = squares(&[(1.0, 0.0)]);
    assert_eq!(shaded(&plane, 1.0), shaded(&plane, 0.0));
    // A square hole over a ground: four triangles around nothing, the ground far below.
    let levels = squares(&[(1.0, 0.0), (0.03, 0.0), (1.0, -0.3)]);
    let quads = [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7], [8, 9, 10, 11]];
    let pit = polygons(levels.positions, &quads.map(|quad| quad.to_vec()));
    assert!(shaded(&pit, 1.0)[0] < shaded(&pit, 0.0)[0] / 2);
}

#[test]
fn equal_pictures_are_equal_bytes_and_read_back() {
    let mesh = face_list(grids::torus(40, 20));
    let draw = || {
        let background = None;
        let picture = Picture { width: 150, height: 100, background, ..Picture::new(mesh.view()) };
        let image = picture.draw().unwrap();
        let mut bytes = Vec::new();
        image.write_png(&mut bytes).unwrap();
        (image, bytes)
    };
    let ((image, bytes), (_, again)) = (draw(), draw());
    assert!(bytes == again);

    let mut reader = png::Decoder::new(std::io::Cursor::new(&bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!((info.width, info.height, info.color_type), (150, 100, png::ColorType::Rgba));
    assert!(pixels == image.pixels().as_flattened());
}

#[test]
fn what_cannot_be_drawn_is_named() {
    let mesh = face_list(classic::octahedron());
    let error = |change: &dyn Fn(&mut Picture)| {
        let mut picture = plain(&mesh, [0.0, 0.0, 1.0]);
        change(&mut picture);
        picture.draw().unwrap_err()
    };
    let empty = Mesh::default();
    assert_eq!(plain(&empty, [1.0; 3]).draw(), Err(PictureError::NoFaces));
    for (width, height, samples) in [(0, 9, 1), (9, 0, 1), (9, 9, 0), (usize::MAX, 2, 2)] {
        let size = PictureError::Size { width, height, samples };
        assert_eq!(error(&|p| (p.width, p.height, p.samples) = (width, height, samples)), size);
    }
    assert_eq!(error(&|p| p.highlights = &[[0, 6]]), PictureError::Vertex(6));
    assert_eq!(
        error(&|p| p.face_colours = &[[0; 3]]),
        PictureError::Colours { colours: 1, faces: 8 }
    );
    for change in [
        (&|p: &mut Picture| p.camera.direction = [0.0; 3]) as &dyn Fn(&mut Picture),
        &|p| p.camera.up[0] = f64::NAN,
        &|p| p.camera.distance = Some(1.0),
        &|p| p.camera.zoom = 0.0,
        &|p| p.camera.margin = 0.5,
    ] {
        assert!(matches!(error(change), PictureError::Camera(_)));
    }
    let flat = Section { point: [0.0; 3], normal: [0.0; 3] };
    assert_eq!(error(&|p| p.section = Some(flat.clone())), PictureError::Section);
    assert_eq!(error(&|p| p.lines.width = -1.0), PictureError::Style);
    assert_eq!(error(&|p| p.depth_shade = f64::NAN), PictureError::Style);

    let triangle = |x: f64, v: u32| polygons(vec![[x; 3], [1.0; 3]], &[vec![0, 1, v]]);
    assert_eq!(plain(&triangle(0.0, 2), [1.0; 3]).draw(), Err(PictureError::Vertex(2)));
    let infinite = triangle(f64::INFINITY, 0);
    assert_eq!(plain(&infinite, [1.0; 3]).draw(), Err(PictureError::NotFinite(0)));
}

/// Any finite number, most of them of an ordinary size.
fn coordinate() -> impl Strategy<Value = f64> {
    use proptest::num::f64::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    prop_oneof![6 => -2.0..2.0, 1 => POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO]
}

fn point() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(coordinate())
}

proptest! {
    #[test]
    fn nothing_finite_panics(
        positions in prop::collection::vec(point(), 6),
        faces in prop::collection::vec(prop::collection::vec(0..6u32, 0..6), 1..6),
        (direction, up, target) in (point(), point(), prop::option::of(point())),
        (distance, zoom) in (prop::option::of(coordinate()), coordinate()),
        section in prop::option::of((point(), point())),
    ) {
        let mesh = polygons(positions, &faces);
        let camera = Camera {
            direction,
            up,
            target,
            distance: distance.map(|x| 1.0 + x.abs()),
            zoom: zoom.abs(),
            margin: 0.1,
        };
        let picture = Picture {
            width: 12,
            height: 9,
            camera,
            highlights: &[[0, 5]],
            section: section.map(|(point, normal)| Section { point, normal }),
            ..Picture::new(mesh.view())
        };
        let once = picture.draw();
        prop_assert_eq!(once, picture.draw());
    }
}
