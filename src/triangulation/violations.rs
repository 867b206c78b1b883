//! Broken laws while a mesh is examined.

use super::laws::{Element, Law, Violation};

/// Broken laws while they are being found.
#[derive(Default)]
pub(super) struct Violations(Vec<Violation>);

impl Violations {
    pub(super) fn add(&mut self, law: Law, element: Element) {
        self.add_at(law, element, Vec::new);
    }

    /// Adds an element with the faces there; `faces` is called for the first element of a law only.
    pub(super) fn add_at(
        &mut self,
        law: Law,
        element: Element,
        faces: impl FnOnce() -> Vec<usize>,
    ) {
        match self.0.iter_mut().find(|violation| violation.law == law) {
            Some(violation) => violation.count += 1,
            None => self.0.push(Violation {
                law,
                element,
                count: 1,
                faces: faces(),
                absent_vertex: None,
            }),
        }
    }

    pub(super) fn none(&self, law: Law) -> bool {
        self.0.iter().all(|violation| violation.law != law)
    }

    /// Returns whether all faces belong to surfaces, open or closed, of one side or two.
    pub(super) fn is_surface(&self) -> bool {
        let harmless =
            [Law::Triangle, Law::NoBoundary, Law::Orientable, Law::ConsistentOrientation];
        self.0.iter().all(|violation| harmless.contains(&violation.law))
    }

    pub(super) fn into_sorted(mut self) -> Vec<Violation> {
        self.0.sort_by_key(|violation| violation.law);
        self.0
    }
}
