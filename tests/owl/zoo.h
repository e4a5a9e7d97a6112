#pragma once

// One ontology with every kind of class expression and axiom, in both syntaxes.

namespace partonomy::owl::zoo {

inline const char* const turtle = R"ttl(@prefix : <https://example.org/zoo#> .
@prefix owl: <http://www.w3.org/2002/07/owl#> .
@prefix rdf: <http://www.w3.org/1999/02/22-rdf-syntax-ns#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
@prefix xsd: <http://www.w3.org/2001/XMLSchema#> .

<https://example.org/zoo> a owl:Ontology ; rdfs:label "zoo"@en ; owl:versionInfo "1" .

:A a owl:Class . :B a owl:Class . :C a owl:Class . :D a owl:Class .
:p a owl:ObjectProperty . :q a owl:ObjectProperty . :r a owl:ObjectProperty .
:d a owl:DatatypeProperty . :e a owl:DatatypeProperty .
:note a owl:AnnotationProperty .
:x a owl:NamedIndividual . :y a owl:NamedIndividual . :z a owl:NamedIndividual .

:A rdfs:subClassOf :B ,
        [ a owl:Class ; owl:intersectionOf ( :B :C [ a owl:Class ; owl:unionOf ( :C :D ) ] ) ] ,
        [ a owl:Class ; owl:complementOf :C ] ,
        [ a owl:Class ; owl:oneOf ( :x :y ) ] ,
        [ a owl:Restriction ; owl:onProperty :p ; owl:someValuesFrom :B ] ,
        [ a owl:Restriction ; owl:onProperty :p ; owl:allValuesFrom [ a owl:Class ; owl:complementOf :D ] ] ,
        [ a owl:Restriction ; owl:onProperty :p ; owl:hasValue :x ] ,
        [ a owl:Restriction ; owl:onProperty :p ; owl:hasSelf true ] ,
        [ a owl:Restriction ; owl:onProperty :p ; owl:minCardinality "2"^^xsd:nonNegativeInteger ] ,
        [ a owl:Restriction ; owl:onProperty :p ; owl:maxQualifiedCardinality "3"^^xsd:nonNegativeInteger ; owl:onClass :C ] ,
        [ a owl:Restriction ; owl:onProperty [ owl:inverseOf :p ] ; owl:qualifiedCardinality "1"^^xsd:nonNegativeInteger ; owl:onClass :D ] ,
        [ a owl:Restriction ; owl:onProperty :d ; owl:someValuesFrom [ a rdfs:Datatype ; owl:onDatatype xsd:double ;
            owl:withRestrictions ( [ xsd:minInclusive "0.4"^^xsd:double ] [ xsd:maxInclusive "0.48"^^xsd:double ] ) ] ] ,
        [ a owl:Restriction ; owl:onProperty :d ; owl:allValuesFrom [ a rdfs:Datatype ; owl:oneOf ( 1 2 ) ] ] ,
        [ a owl:Restriction ; owl:onProperty :d ; owl:hasValue "red"@en ] ,
        [ a owl:Restriction ; owl:onProperty :d ; owl:minQualifiedCardinality "1"^^xsd:nonNegativeInteger ; owl:onDataRange xsd:string ] ,
        [ a owl:Restriction ; owl:onProperty :d ; owl:maxCardinality "4"^^xsd:nonNegativeInteger ] ,
        [ a owl:Restriction ; owl:onProperty :d ; owl:cardinality "5"^^xsd:nonNegativeInteger ] .
:B owl:equivalentClass :C .
:B owl:disjointWith :D .
:D owl:disjointUnionOf ( :B :C ) .
[] a owl:AllDisjointClasses ; owl:members ( :A :B :C ) .
:p rdfs:subPropertyOf :q .
:r owl:propertyChainAxiom ( :p [ owl:inverseOf :q ] ) .
:p owl:equivalentProperty :q .
:p owl:inverseOf :r .
:p owl:propertyDisjointWith :r .
[] a owl:AllDisjointProperties ; owl:members ( :p :q :r ) .
:p rdfs:domain :A .
:p rdfs:range :B .
:p a owl:FunctionalProperty .
:p a owl:InverseFunctionalProperty .
:p a owl:SymmetricProperty .
:p a owl:AsymmetricProperty .
:p a owl:TransitiveProperty .
:p a owl:ReflexiveProperty .
:p a owl:IrreflexiveProperty .
:d rdfs:subPropertyOf :e .
:d owl:equivalentProperty :e .
:d owl:propertyDisjointWith :e .
:d rdfs:domain :A .
:d rdfs:range xsd:double .
:d a owl:FunctionalProperty .
:x a :A .
:x :p :y .
[] a owl:NegativePropertyAssertion ; owl:sourceIndividual :x ; owl:assertionProperty :p ; owl:targetIndividual :z .
:x :d 0.5 .
:x owl:sameAs :y .
:x owl:differentFrom :z .
[] a owl:AllDifferent ; owl:distinctMembers ( :x :y :z ) .
:A rdfs:label "a"@en , "un a"@fr , "plain" ; rdfs:comment """two
lines""" ; :note :x ; :unheard "kept" .
:B rdfs:subClassOf :A .
[] a owl:Axiom ; owl:annotatedSource :B ; owl:annotatedProperty rdfs:subClassOf ; owl:annotatedTarget :A ; rdfs:comment "why" .
[ a owl:Restriction ; owl:onProperty :q ; owl:someValuesFrom owl:Thing ] rdfs:subClassOf :C .
:C owl:unionOf ( :A :B ) .
)ttl";

/// Line and wording of each axiom of `turtle`.
inline const char* const axioms[] = {
    "15 A SubClassOf: B",
    "16 A SubClassOf: B and C and (C or D)",
    "17 A SubClassOf: not C",
    "18 A SubClassOf: {x, y}",
    "19 A SubClassOf: p some B",
    "20 A SubClassOf: p only (not D)",
    "21 A SubClassOf: p value x",
    "22 A SubClassOf: p Self",
    "23 A SubClassOf: p min 2 Thing",
    "24 A SubClassOf: p max 3 C",
    "25 A SubClassOf: inverse (p) exactly 1 D",
    "26 A SubClassOf: d some xsd:double[>= 0.4, <= 0.48]",
    "28 A SubClassOf: d only {1, 2}",
    "29 A SubClassOf: d value \"red\"@en",
    "30 A SubClassOf: d min 1 xsd:string",
    "31 A SubClassOf: d max 4 rdfs:Literal",
    "32 A SubClassOf: d exactly 5 rdfs:Literal",
    "33 B EquivalentTo: C",
    "34 B DisjointWith: D",
    "35 D DisjointUnionOf: B, C",
    "36 DisjointClasses: A, B, C",
    "37 p SubPropertyOf: q",
    "38 r SubPropertyChain: p o inverse (q)",
    "39 p EquivalentTo: q",
    "40 p InverseOf: r",
    "41 p DisjointWith: r",
    "42 DisjointProperties: p, q, r",
    "43 p Domain: A",
    "44 p Range: B",
    "45 p Characteristics: Functional",
    "46 p Characteristics: InverseFunctional",
    "47 p Characteristics: Symmetric",
    "48 p Characteristics: Asymmetric",
    "49 p Characteristics: Transitive",
    "50 p Characteristics: Reflexive",
    "51 p Characteristics: Irreflexive",
    "52 d SubPropertyOf: e",
    "53 d EquivalentTo: e",
    "54 d DisjointWith: e",
    "55 d Domain: A",
    "56 d Range: xsd:double",
    "57 d Characteristics: Functional",
    "58 x Types: A",
    "59 x Facts: p y",
    "60 x Facts: not p z",
    "61 x Facts: d 0.5",
    "62 x SameAs: y",
    "63 x DifferentFrom: z",
    "64 DifferentIndividuals: x, y, z",
    "67 B SubClassOf: A",
    "69 q some Thing SubClassOf: C",
    "70 C EquivalentTo: A or B",
};

inline const char* const rdf_xml = R"xml(<?xml version="1.0"?>
<!DOCTYPE rdf:RDF [
    <!ENTITY owl "http://www.w3.org/2002/07/owl#" >
    <!ENTITY xsd "http://www.w3.org/2001/XMLSchema#" >
    <!ENTITY zoo "https://example.org/zoo#" >
]>
<rdf:RDF xmlns="https://example.org/zoo#"
     xml:base="https://example.org/zoo"
     xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#"
     xmlns:owl="http://www.w3.org/2002/07/owl#"
     xmlns:rdfs="http://www.w3.org/2000/01/rdf-schema#">
    <owl:Ontology rdf:about="https://example.org/zoo"><rdfs:label xml:lang="en">zoo</rdfs:label><owl:versionInfo>1</owl:versionInfo></owl:Ontology>

    <owl:ObjectProperty rdf:about="&zoo;p">
        <rdf:type rdf:resource="&owl;FunctionalProperty"/>
        <rdf:type rdf:resource="&owl;InverseFunctionalProperty"/>
        <rdf:type rdf:resource="&owl;SymmetricProperty"/>
        <rdf:type rdf:resource="&owl;AsymmetricProperty"/>
        <rdf:type rdf:resource="&owl;TransitiveProperty"/>
        <rdf:type rdf:resource="&owl;ReflexiveProperty"/>
        <rdf:type rdf:resource="&owl;IrreflexiveProperty"/>
        <rdfs:subPropertyOf rdf:resource="#q"/>
        <owl:equivalentProperty rdf:resource="#q"/>
        <owl:inverseOf rdf:resource="#r"/>
        <owl:propertyDisjointWith rdf:resource="#r"/>
        <rdfs:domain rdf:resource="#A"/>
        <rdfs:range rdf:resource="#B"/>
    </owl:ObjectProperty>
    <owl:ObjectProperty rdf:ID="q"/>
    <owl:ObjectProperty rdf:about="#r">
        <owl:propertyChainAxiom rdf:parseType="Collection">
            <rdf:Description rdf:about="#p"/>
            <rdf:Description>
                <owl:inverseOf rdf:resource="#q"/>
            </rdf:Description>
        </owl:propertyChainAxiom>
    </owl:ObjectProperty>
    <owl:DatatypeProperty rdf:about="#d">
        <rdf:type rdf:resource="&owl;FunctionalProperty"/>
        <rdfs:subPropertyOf rdf:resource="#e"/>
        <owl:equivalentProperty rdf:resource="#e"/>
        <owl:propertyDisjointWith rdf:resource="#e"/>
        <rdfs:domain rdf:resource="#A"/>
        <rdfs:range rdf:resource="&xsd;double"/>
    </owl:DatatypeProperty>
    <owl:DatatypeProperty rdf:about="#e"/>
    <owl:AnnotationProperty rdf:about="#note"/>

    <owl:Class rdf:about="#A">
        <rdfs:subClassOf rdf:resource="#B"/>
        <rdfs:subClassOf>
            <owl:Class>
                <owl:intersectionOf rdf:parseType="Collection">
                    <rdf:Description rdf:about="#B"/>
                    <rdf:Description rdf:about="#C"/>
                    <owl:Class><owl:unionOf rdf:parseType="Collection"><rdf:Description rdf:about="#C"/><rdf:Description rdf:about="#D"/></owl:unionOf></owl:Class>
                </owl:intersectionOf>
            </owl:Class>
        </rdfs:subClassOf>
        <rdfs:subClassOf><owl:Class><owl:complementOf rdf:resource="#C"/></owl:Class></rdfs:subClassOf>
        <rdfs:subClassOf>
            <owl:Class>
                <owl:oneOf rdf:parseType="Collection"><owl:NamedIndividual rdf:about="#x"/><rdf:Description rdf:about="#y"/></owl:oneOf>
            </owl:Class>
        </rdfs:subClassOf>
        <rdfs:subClassOf>
            <owl:Restriction>
                <owl:onProperty rdf:resource="#p"/>
                <owl:someValuesFrom rdf:resource="#B"/>
            </owl:Restriction>
        </rdfs:subClassOf>
        <rdfs:subClassOf>
            <owl:Restriction>
                <owl:onProperty rdf:resource="#p"/>
                <owl:allValuesFrom><owl:Class><owl:complementOf rdf:resource="#D"/></owl:Class></owl:allValuesFrom>
            </owl:Restriction>
        </rdfs:subClassOf>
        <rdfs:subClassOf>
            <owl:Restriction>
                <owl:onProperty rdf:resource="#p"/>
                <owl:hasValue rdf:resource="#x"/>
            </owl:Restriction>
        </rdfs:subClassOf>
        <rdfs:subClassOf>
            <owl:Restriction>
                <owl:onProperty rdf:resource="#p"/>
                <owl:hasSelf rdf:datatype="&xsd;boolean">true</owl:hasSelf>
            </owl:Restriction>
        </rdfs:subClassOf>
        <rdfs:subClassOf>
            <owl:Restriction>
                <owl:onProperty rdf:resource="#p"/>
                <owl:minCardinality rdf:datatype="&xsd;nonNegativeInteger">2</owl:minCardinality>
            </owl:Restriction>
        </rdfs:subClassOf>
        <rdfs:subClassOf>
            <owl:Restriction>
                <owl:onProperty rdf:resource="#p"/>
                <owl:maxQualifiedCardinality rdf:datatype="&xsd;nonNegativeInteger">3</owl:maxQualifiedCardinality>
                <owl:onClass rdf:resource="#C"/>
            </owl:Restriction>
        </rdfs:subClassOf>
        <rdfs:subClassOf>
            <owl:Restriction>
                <owl:onProperty rdf:parseType="Resource"><owl:inverseOf rdf:resource="#p"/></owl:onProperty>
                <owl:qualifiedCardinality rdf:datatype="&xsd;nonNegativeInteger">1</owl:qualifiedCardinality>
                <owl:onClass rdf:resource="#D"/>
            </owl:Restriction>
        </rdfs:subClassOf>
        <rdfs:subClassOf>
            <owl:Restriction>
                <owl:onProperty rdf:resource="#d"/>
                <owl:someValuesFrom>
                    <rdfs:Datatype>
                        <owl:onDatatype rdf:resource="&xsd;double"/>
                        <owl:withRestrictions rdf:parseType="Collection">
                            <rdf:Description><xsd:minInclusive xmlns:xsd="&xsd;" rdf:datatype="&xsd;double">0.4</xsd:minInclusive></rdf:Description>
                            <rdf:Description><xsd:maxInclusive xmlns:xsd="&xsd;" rdf:datatype="&xsd;double">0.48</xsd:maxInclusive></rdf:Description>
                        </owl:withRestrictions>
                    </rdfs:Datatype>
                </owl:someValuesFrom>
            </owl:Restriction>
        </rdfs:subClassOf>
        <rdfs:subClassOf>
            <owl:Restriction>
                <owl:onProperty rdf:resource="#d"/>
                <owl:allValuesFrom>
                    <rdfs:Datatype>
                        <owl:oneOf>
                            <rdf:Description>
                                <rdf:type rdf:resource="http://www.w3.org/1999/02/22-rdf-syntax-ns#List"/>
                                <rdf:first rdf:datatype="&xsd;integer">1</rdf:first>
                                <rdf:rest>
                                    <rdf:Description>
                                        <rdf:first rdf:datatype="&xsd;integer">2</rdf:first>
                                        <rdf:rest rdf:resource="http://www.w3.org/1999/02/22-rdf-syntax-ns#nil"/>
                                    </rdf:Description>
                                </rdf:rest>
                            </rdf:Description>
                        </owl:oneOf>
                    </rdfs:Datatype>
                </owl:allValuesFrom>
            </owl:Restriction>
        </rdfs:subClassOf>
        <rdfs:subClassOf>
            <owl:Restriction>
                <owl:onProperty rdf:resource="#d"/>
                <owl:hasValue xml:lang="en">red</owl:hasValue>
            </owl:Restriction>
        </rdfs:subClassOf>
        <rdfs:subClassOf>
            <owl:Restriction>
                <owl:onProperty rdf:resource="#d"/>
                <owl:minQualifiedCardinality rdf:datatype="&xsd;nonNegativeInteger">1</owl:minQualifiedCardinality>
                <owl:onDataRange rdf:resource="&xsd;string"/>
            </owl:Restriction>
        </rdfs:subClassOf>
        <rdfs:subClassOf>
            <owl:Restriction>
                <owl:onProperty rdf:resource="#d"/>
                <owl:maxCardinality rdf:datatype="&xsd;nonNegativeInteger">4</owl:maxCardinality>
            </owl:Restriction>
        </rdfs:subClassOf>
        <rdfs:subClassOf>
            <owl:Restriction>
                <owl:onProperty rdf:resource="#d"/>
                <owl:cardinality rdf:datatype="&xsd;nonNegativeInteger">5</owl:cardinality>
            </owl:Restriction>
        </rdfs:subClassOf>
        <rdfs:label xml:lang="en">a</rdfs:label>
        <rdfs:label xml:lang="fr">un a</rdfs:label>
        <rdfs:label>plain</rdfs:label>
        <rdfs:comment>two
lines</rdfs:comment>
        <note rdf:resource="#x"/>
        <unheard>kept</unheard>
    </owl:Class>
    <owl:Class rdf:about="#B">
        <owl:equivalentClass rdf:resource="#C"/>
        <rdfs:subClassOf rdf:resource="#A"/>
        <owl:disjointWith rdf:resource="#D"/>
    </owl:Class>
    <owl:Axiom>
        <owl:annotatedSource rdf:resource="#B"/>
        <owl:annotatedProperty rdf:resource="http://www.w3.org/2000/01/rdf-schema#subClassOf"/>
        <owl:annotatedTarget rdf:resource="#A"/>
        <rdfs:comment>why</rdfs:comment>
    </owl:Axiom>
    <owl:Class rdf:about="#C">
        <owl:unionOf rdf:parseType="Collection">
            <rdf:Description rdf:about="#A"/>
            <rdf:Description rdf:about="#B"/>
        </owl:unionOf>
    </owl:Class>
    <owl:Class rdf:about="#D">
        <owl:disjointUnionOf rdf:parseType="Collection">
            <rdf:Description rdf:about="#B"/>
            <rdf:Description rdf:about="#C"/>
        </owl:disjointUnionOf>
    </owl:Class>
    <owl:Restriction>
        <owl:onProperty rdf:resource="#q"/>
        <owl:someValuesFrom rdf:resource="&owl;Thing"/>
        <rdfs:subClassOf rdf:resource="#C"/>
    </owl:Restriction>

    <owl:NamedIndividual rdf:about="#x">
        <rdf:type rdf:resource="#A"/>
        <owl:sameAs rdf:resource="#y"/>
        <owl:differentFrom rdf:resource="#z"/>
        <p rdf:resource="#y"/>
        <d rdf:datatype="&xsd;decimal">0.5</d>
    </owl:NamedIndividual>
    <owl:NamedIndividual rdf:about="#y"/>
    <owl:NamedIndividual rdf:about="#z"/>
    <rdf:Description>
        <rdf:type rdf:resource="&owl;AllDisjointClasses"/>
        <owl:members rdf:parseType="Collection"><rdf:Description rdf:about="#A"/><rdf:Description rdf:about="#B"/><rdf:Description rdf:about="#C"/></owl:members>
    </rdf:Description>
    <rdf:Description>
        <rdf:type rdf:resource="&owl;AllDisjointProperties"/>
        <owl:members rdf:parseType="Collection"><rdf:Description rdf:about="#p"/><rdf:Description rdf:about="#q"/><rdf:Description rdf:about="#r"/></owl:members>
    </rdf:Description>
    <owl:AllDifferent>
        <owl:distinctMembers rdf:parseType="Collection"><rdf:Description rdf:about="#x"/><rdf:Description rdf:about="#y"/><rdf:Description rdf:about="#z"/></owl:distinctMembers>
    </owl:AllDifferent>
    <owl:NegativePropertyAssertion>
        <owl:sourceIndividual rdf:resource="#x"/>
        <owl:assertionProperty rdf:resource="#p"/>
        <owl:targetIndividual rdf:resource="#z"/>
    </owl:NegativePropertyAssertion>
</rdf:RDF>
)xml";

}  // namespace partonomy::owl::zoo
