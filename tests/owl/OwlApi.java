import java.io.File;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Set;
import org.coode.owlapi.manchesterowlsyntax.ManchesterOWLSyntaxOntologyFormat;
import org.coode.owlapi.turtle.TurtleOntologyFormat;
import org.semanticweb.owlapi.apibinding.OWLManager;
import org.semanticweb.owlapi.io.OWLFunctionalSyntaxOntologyFormat;
import org.semanticweb.owlapi.io.OWLXMLOntologyFormat;
import org.semanticweb.owlapi.io.RDFXMLOntologyFormat;
import org.semanticweb.owlapi.model.*;

/**
 * The OWL API's opinion on files, and its own files for ours: it comes with HermiT, and Protégé saves with it.
 *
 * <p>{@code java -cp HermiT.jar OwlApi.java convert FILE STEM}: FILE in five syntaxes as STEM.ttl, STEM.rdf, STEM.owx,
 * STEM.ofn, STEM.omn. {@code … compare FILE OTHER FILE OTHER …}: for each pair prints "same" or the axioms in which OTHER
 * differs from FILE.
 */
public class OwlApi {
    static OWLOntology load(String path) throws Exception {
        return OWLManager.createOWLOntologyManager().loadOntologyFromOntologyDocument(new File(path));
    }

    static void convert(String path, String stem) throws Exception {
        OWLOntology ontology = load(path);
        OWLOntologyFormat[] formats = {
            new TurtleOntologyFormat(), new RDFXMLOntologyFormat(), new OWLXMLOntologyFormat(),
            new OWLFunctionalSyntaxOntologyFormat(), new ManchesterOWLSyntaxOntologyFormat()
        };
        String[] types = {"ttl", "rdf", "owx", "ofn", "omn"};
        OWLOntologyFormat from = ontology.getOWLOntologyManager().getOntologyFormat(ontology);
        for (int i = 0; i < formats.length; ++i) {
            if (from.isPrefixOWLOntologyFormat())
                formats[i].asPrefixOWLOntologyFormat().copyPrefixesFrom(from.asPrefixOWLOntologyFormat());
            IRI target = IRI.create(new File(stem + "." + types[i]));
            ontology.getOWLOntologyManager().saveOntology(ontology, formats[i], target);
        }
    }

    /** Axioms without what the OWL API invents: names of anonymous individuals, and that p is inverse to its inverse. */
    static Set<String> axioms(OWLOntology ontology) {
        Set<String> texts = new java.util.TreeSet<>();
        for (OWLAxiom axiom : ontology.getAxioms()) {
            String text = axiom.toString();
            if (!text.matches("InverseObjectProperties\\(InverseOf\\((<[^>]*>)\\) \\1\\)"))
                texts.add(text.replaceAll("_:[^ )>]*", "_:"));
        }
        return texts;
    }

    public static void main(String[] arguments) throws Exception {
        PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
        if (arguments[0].equals("convert")) {
            convert(arguments[1], arguments[2]);
            return;
        }
        for (int i = 1; i < arguments.length; i += 2) {
            Set<String> expected = axioms(load(arguments[i]));
            Set<String> found = axioms(load(arguments[i + 1]));
            if (found.equals(expected)) out.println("same");
            for (String axiom : expected) if (!found.contains(axiom)) out.println(arguments[i + 1] + " lost " + axiom);
            for (String axiom : found) if (!expected.contains(axiom)) out.println(arguments[i + 1] + " new " + axiom);
        }
    }
}
