//! Conversion into quads and the triangles left over: of open and one-sided surfaces, and where
//! triangles may stay.

use std::borrow::Cow;

use super::closed::unsolved;
use super::converted::Converted;
use super::converter::Converter;
use super::error::ConvertError;
use super::progress::Stage;
use super::report::Report;
use crate::augmentation::make_maximum;
use crate::dual::{DualGraph, Matching};
use crate::mesh::Mesh;
use crate::pairing::{Algorithm, Proof, best_matching, fewest_left_over};
use crate::quadrangulation::quality::Quality;
use crate::quadrangulation::{CheckReport, MixedCheck, MixedFaces, SharpEdges, check_mixed_faces};
use crate::random::Random;
use crate::triangulation::{Surface, VertexId};

impl Converter<'_> {
    /// Converts a mesh whose surface is given.
    pub(super) fn run_mixed<S: Surface>(
        &mut self,
        surface: &S,
        mesh: Cow<'_, Mesh>,
        mut report: Report,
    ) -> Result<Converted, ConvertError> {
        self.enter(Stage::Pairing);
        report.unreferenced_vertices = mesh.positions().len() - report.vertices;
        let dual = DualGraph::new(surface);
        let (matching, proof) = if self.algorithm == Algorithm::Best {
            let (matching, proof) = self.match_by_cost(surface, &dual, &mesh, &mut report)?;
            (matching, Some(proof))
        } else {
            (self.match_by_name(surface, &dual, &mesh, &mut report)?, None)
        };
        report.leftover_triangles = Some(matching.unpaired_count());
        let given_up = proof.iter().flat_map(|proof| &proof.given_up);
        let given_up = given_up.map(|&h| surface.ends(h).map(VertexId::into)).collect();
        let proof = proof.filter(|_| self.keep_proof);
        let mixed = MixedFaces::new(surface, &matching);
        drop((matching, dual));

        self.enter(Stage::Checking);
        let vertices = mesh.positions().len();
        let (check, check_seconds) =
            self.time(|_| check_mixed_faces(mixed.faces(), mesh.faces(), vertices));
        let MixedCheck { report: CheckReport { quads, degree_two_vertices, .. }, .. } = check?;
        report.sharp_edges = Some(SharpEdges::new(surface, mesh.positions(), mixed.removed()));
        let attributes = mixed.carry_attributes(&mesh);
        let losses = mixed.attribute_losses(surface, &mesh);
        let mut mesh = mesh.into_owned();
        let triangles = mesh.replace_faces(mixed.into_faces());
        let mesh = mesh.attach(attributes);
        report.quads = quads;
        report.degree_two_vertices = degree_two_vertices;
        report.quality = Some(Quality::new(&mesh));
        report.check_seconds += check_seconds;
        Ok(Converted { mesh, triangles, report, losses, proof, given_up })
    }

    /// Finds the best matching and verifies its proof.
    fn match_by_cost(
        &mut self,
        surface: &impl Surface,
        dual: &DualGraph,
        mesh: &Mesh,
        report: &mut Report,
    ) -> Result<(Matching, Proof), ConvertError> {
        let (objective, cost_seconds) =
            self.time(|settings| settings.aims.objective(surface, mesh));
        let objective = objective?;
        let (found, seconds) = self.time(|settings| {
            let mut silent = ();
            let progress = settings.progress.as_deref_mut().unwrap_or(&mut silent);
            best_matching(dual, objective, &mut |news| progress.searching(news.roots))
        });
        report.cost_seconds = cost_seconds;
        report.pairing_seconds = cost_seconds + seconds;
        let (matching, proof) = found.map_err(|error| unsolved(error, report))?;
        let (verdict, seconds) = self.time(|_| proof.verify(dual, &matching));
        verdict?;
        report.check_seconds = seconds;
        report.is_proved_least = true;
        report.is_proved_fewest = self.aims.price.is_none();
        report.unpaired_triangles = matching.unpaired_count();
        self.note(&proof, report);
        Ok((matching, proof))
    }

    /// Finds a maximum matching by the chosen algorithm and proves that it is one.
    fn match_by_name(
        &mut self,
        surface: &impl Surface,
        dual: &DualGraph,
        mesh: &Mesh,
        report: &mut Report,
    ) -> Result<Matching, ConvertError> {
        let mut random = Random::stream(self.seed, &[self.algorithm.id()]);
        let (initial, seconds) =
            self.time(|settings| settings.algorithm.pair_open(surface, dual, mesh, &mut random));
        let initial = initial.ok_or(ConvertError::NeedsClosed(self.algorithm))?;
        report.pairing_seconds = seconds;
        report.unpaired_triangles = initial.unpaired_count();
        self.enter(Stage::Augmenting(report.unpaired_triangles / 2));
        let mut stopped = false;
        let ((matching, paths), seconds) = self.time(|settings| {
            let mut silent = ();
            let progress = settings.progress.as_deref_mut().unwrap_or(&mut silent);
            make_maximum(dual, initial, settings.augmentation, || {
                let flow = progress.path_found();
                stopped |= flow.is_break();
                flow
            })
        });
        report.paths = paths;
        report.augmentation_seconds = seconds;
        if stopped {
            report.stopped = true;
            return Err(ConvertError::Stopped(Box::new(report.clone())));
        }
        let (proved, seconds) = self.time(|_| fewest_left_over(dual));
        report.check_seconds = seconds;
        if proved? != matching.unpaired_count() {
            return Err(ConvertError::NotFewest);
        }
        report.is_proved_fewest = true;
        Ok(matching)
    }
}
